// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the vector loops with the scalar test, for each kind of processor that this machine can
// run.
#include "core/neighbours/meeting_slots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/geometry/lattice_point.hpp"
#include "core/predicates/grown_balls.hpp"
#include "tests/support/for_processors.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::for_processors;
using testing::random_int;

// Balls, and beyond them kVectorRoom that always meet. They must not be found.
class Columns {
 public:
  void add(std::int32_t x, std::int32_t y, std::int32_t z, float reach) {
    x_.push_back(x);
    y_.push_back(y);
    z_.push_back(z);
    reach_.push_back(reach);
  }
  void close() {
    count_ = x_.size();
    for (std::size_t n = 0; n < kVectorRoom; ++n) add(0, 0, 0, HUGE_VALF);
  }
  std::size_t size() const { return count_; }
  BallColumns view() const { return {x_.data(), y_.data(), z_.data(), reach_.data()}; }
  GrownBall ball(std::size_t n) const { return {x_[n], y_[n], z_[n], reach_[n]}; }
  bool meet(std::size_t a, const GrownBall& b) const {
    return grown_balls_may_meet(x_[a] - b.x, y_[a] - b.y, z_[a] - b.z, b.reach, reach_[a]);
  }

 private:
  std::vector<std::int32_t> x_, y_, z_;
  std::vector<float> reach_;
  std::size_t count_ = 0;
};

Columns random_columns(testing::Random& random, int count, int extent) {
  Columns columns;
  for (int n = 0; n < count; ++n) {
    const auto coordinate = [&] { return random_int(random, -extent, extent); };
    columns.add(coordinate(), coordinate(), coordinate(),
                static_cast<float>(random_int(random, 0, extent)) * 0.7f);
  }
  columns.close();
  return columns;
}

std::vector<std::uint32_t> expected_slots(const Columns& columns,
                                          const std::vector<SlotRange>& ranges,
                                          const GrownBall& ball, std::uint32_t self) {
  std::vector<std::uint32_t> slots;
  for (const SlotRange& range : ranges) {
    for (std::uint32_t s = range.begin; s < range.end; ++s) {
      if (s != self && columns.meet(s, ball)) slots.push_back(s);
    }
  }
  return slots;
}

std::vector<std::uint32_t> found_slots(const Columns& columns, const std::vector<SlotRange>& ranges,
                                       const GrownBall& ball, std::uint32_t self) {
  std::size_t most = kVectorRoom;
  for (const SlotRange& range : ranges) most += range.end - range.begin;
  std::vector<std::uint32_t> slots(most);
  slots.resize(find_meeting(columns.view(), ranges, ball, self, slots.data()));
  return slots;
}

std::vector<std::uint32_t> marked_slots(const Columns& columns, std::size_t count,
                                        const GrownBall& ball) {
  std::vector<std::uint32_t> bits((count + 31) / 32, 0xA5A5A5A5u), slots;
  mark_meeting(columns.view(), count, ball, bits.data());
  for (std::uint32_t s = 0; s < 32 * bits.size(); ++s) {
    if ((bits[s / 32] >> s % 32 & 1) != 0) slots.push_back(s);
  }
  return slots;
}

TEST(MeetingSlots, AreThoseOfTheScalarTest) {
  testing::Random random(7);
  constexpr std::uint32_t kNobody = ~std::uint32_t{0};
  for_processors([&] {
    for (const int extent : {3, 2000, kMaxLatticeCoordinate}) {
      for (int count = 1; count < 120; count += random_int(random, 1, 9)) {
        const Columns columns = random_columns(random, count, extent);
        const auto all = static_cast<std::uint32_t>(columns.size());
        const std::uint32_t self = static_cast<std::uint32_t>(random_int(random, 0, count - 1));
        const std::uint32_t cut = static_cast<std::uint32_t>(random_int(random, 0, count));
        const GrownBall ball = columns.ball(self);
        for (const auto& ranges : std::vector<std::vector<SlotRange>>{
                 {{0, all}}, {{0, cut}, {cut, all}}, {{cut, all}, {cut, cut}, {0, cut}}, {}}) {
          EXPECT_EQ(found_slots(columns, ranges, ball, self),
                    expected_slots(columns, ranges, ball, self));
        }
        EXPECT_EQ(marked_slots(columns, columns.size(), ball),
                  expected_slots(columns, {{0, all}}, ball, kNobody));
      }
    }
  });
}

// Pairs at the bound of the test, where a fused or reordered operation would decide otherwise.
TEST(MeetingSlots, AreTheSameWhereBallsJustMeet) {
  testing::Random random(8);
  std::size_t meeting = 0, others = 0;
  for_processors([&] {
    Columns columns;
    const GrownBall ball{random_int(random, -9, 9), 5, -7, 123.456f};
    for (int n = 0; n < 4000; ++n) {
      const std::int32_t x = random_int(random, -50000, 50000),
                         y = random_int(random, -50000, 50000),
                         z = random_int(random, -50000, 50000);
      const double distance = std::sqrt(std::pow(x - ball.x, 2.0) + std::pow(y - ball.y, 2.0) +
                                        std::pow(z - ball.z, 2.0));
      float reach = static_cast<float>(distance) - ball.reach;
      for (int step = random_int(random, -2, 2); step != 0; step += step < 0 ? 1 : -1) {
        reach = std::nextafter(reach, step < 0 ? 0 : std::numeric_limits<float>::infinity());
      }
      columns.add(x, y, z, reach);
    }
    columns.close();
    const auto all = static_cast<std::uint32_t>(columns.size());
    const std::vector<std::uint32_t> expected = expected_slots(columns, {{0, all}}, ball, all);
    EXPECT_EQ(found_slots(columns, {{0, all}}, ball, all), expected);
    EXPECT_EQ(marked_slots(columns, all, ball), expected);
    meeting += expected.size();
    others += all - expected.size();
  });
  EXPECT_GT(meeting, 500u);
  EXPECT_GT(others, 500u);
}

TEST(SortByKey, PutsEachSlotInItsPlace) {
  testing::Random random(9);
  for_processors([&] {
    for (std::size_t count = 0; count < 150; ++count) {  // more than are counted
      std::vector<std::uint32_t> keys(count + kVectorRoom, 0), slots(count), sorted(count);
      for (std::size_t n = 0; n < count; ++n) {
        keys[n] = static_cast<std::uint32_t>(n) * 28'000'000u + 3;  // the last ones exceed 2^31
        slots[n] = static_cast<std::uint32_t>(n);
      }
      for (std::size_t n = count; n > 1; --n) {
        const auto other = static_cast<std::size_t>(random_int(random, 0, static_cast<int>(n) - 1));
        std::swap(keys[n - 1], keys[other]);
      }
      sort_by_key({keys.data(), count}, slots.data(), sorted.data());
      std::sort(slots.begin(), slots.end(),
                [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
      EXPECT_EQ(sorted, slots);
    }
  });
}

}  // namespace
}  // namespace alphascope
