#include "gpu/ball_wire.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <random>

namespace alphascope::gpu {
namespace {

// Balls between two corners, among them both.
std::vector<int4> balls_between(const int4& low, const int4& high, int radii) {
  std::mt19937 random(4);
  const auto any = [&](std::int32_t from, std::int32_t to) {
    return std::uniform_int_distribution<std::int32_t>(from, to)(random);
  };
  std::vector<int4> balls{low, high};
  for (int b = 0; b < 500; ++b)
    balls.push_back(make_int4(any(low.x, high.x), any(low.y, high.y), any(low.z, high.z),
                              b % radii == 0 ? -1 : 1000 * (b % radii)));
  return balls;
}

// Are they the same when they arrive?
void expect_to_arrive(const int4& low, const int4& high, int radii) {
  const std::vector<int4> balls = balls_between(low, high, radii);
  RadiusTable table;
  for (const int4& b : balls) table.number_of(b.w);
  const auto packing = choose_packing(low, high, table.radii.size());
  ASSERT_TRUE(packing.has_value());
  for (const int4& sent : balls) {
    const int4 got =
        packing->unpack(packing->pack(sent, table.number_of(sent.w)), table.radii.data());
    EXPECT_EQ(got.x, sent.x);
    EXPECT_EQ(got.y, sent.y);
    EXPECT_EQ(got.z, sent.z);
    EXPECT_EQ(got.w, sent.w);
  }
}

TEST(BallWire, BringsBallsUnchanged) {
  expect_to_arrive(make_int4(-123456, 7, -1, 0), make_int4(800000, 524294, 1048574, 0), 7);
  expect_to_arrive(make_int4(5, 5, 5, 0), make_int4(5, 5, 5, 0), 1);
  expect_to_arrive(make_int4(INT_MIN, 0, INT_MAX - 3, 0), make_int4(INT_MAX, 9, INT_MAX, 0), 300);
}

TEST(BallWire, LeavesSetsAsTheyAreThatNeedMoreBits) {
  const int4 low = make_int4(INT_MIN, INT_MIN, 0, 0);
  EXPECT_FALSE(choose_packing(low, make_int4(INT_MAX, INT_MAX, 0, 0), 1).has_value());
  EXPECT_FALSE(choose_packing(low, make_int4(INT_MIN + 1, INT_MIN + 1, 1, 0), 5000).has_value());
  // 63 bits at most.
  const int4 zero = make_int4(0, 0, 0, 0);
  EXPECT_TRUE(choose_packing(zero, make_int4(1048575, 1048575, 2097151, 0), 3).has_value());
  EXPECT_FALSE(choose_packing(zero, make_int4(2097151, 2097151, 2097151, 0), 1).has_value());
}

}  // namespace
}  // namespace alphascope::gpu
