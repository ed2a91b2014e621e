// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of inserters that share a triangulation: of their claims on balls, and of the shares of
// threads.
#include "core/insertion/inserter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

#include "core/insertion/stretches.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;
using testing::random_int;

// The first four are not in a plane.
std::vector<InsertedBall> some_balls(int count) {
  Random random(55);
  std::vector<InsertedBall> balls{{0, 0, 0, 1}, {999, 0, 0, 1}, {0, 999, 0, 1}, {0, 0, 999, 1}};
  const auto any = [&] { return static_cast<double>(random_int(random, 1, 998)); };
  while (balls.size() < static_cast<std::size_t>(count)) balls.push_back({any(), any(), any(), 9});
  return balls;
}

// The balls of each tetrahedron.
std::vector<std::array<std::uint32_t, 4>> tetrahedra(const CellStore& store) {
  std::vector<std::array<std::uint32_t, 4>> all;
  for (std::size_t c = 0; c < store.taken(); ++c) {
    const Cell& cell = store.data()[c];
    if (cell.state != Cell::kUsed || cell.at_infinity()) continue;
    all.push_back({cell.ball[0], cell.ball[1], cell.ball[2], cell.ball[3]});
    std::sort(all.back().begin(), all.back().end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Whether an inserter holds two balls of the cell, which nobody has replaced then.
bool may_go_on(const CellStore& store, const Claims& claims, std::uint8_t inserter,
               std::uint32_t at) {
  const Cell& cell = store.data()[at];
  return cell.state == Cell::kUsed &&
         std::count_if(cell.ball, cell.ball + 4, [&](std::uint32_t ball) {
           return ball != Cell::kInfinity && claims.has(inserter, ball);
         }) >= 2;
}

// Inserters take turns on one thread, so that each meets the claims of the others all the time.
TEST(Inserter, SharesATriangulationWithOthers) {
  constexpr std::uint32_t kAlone = 300, kCount = 3000;
  const std::vector<InsertedBall> balls = some_balls(kCount);
  CellStore expected(60000);
  Inserter alone(balls, expected);
  std::uint32_t at = alone.begin({0, 1, 2, 3});
  for (std::uint32_t ball = 4; ball < kCount; ++ball) alone.insert(ball, at);

  CellStore store(60000);
  Claims claims(balls.size());
  std::array<Inserter, 3> inserters{Inserter(balls, store), Inserter(balls, store),
                                    Inserter(balls, store)};
  std::uint32_t start = inserters[0].begin({0, 1, 2, 3});
  for (std::uint32_t ball = 4; ball < kAlone; ++ball) inserters[0].insert(ball, start);
  std::array<std::uint32_t, 3> cells;
  for (std::uint32_t i = 0; i < 3; ++i) cells[i] = inserters[0].cell_near(10 + i, start);
  for (std::uint8_t i = 0; i < 3; ++i)
    ASSERT_TRUE(inserters[i].begin_sharing(claims, static_cast<std::uint8_t>(i + 1), cells[i]));
  std::vector<std::uint32_t> put_off;
  for (std::uint32_t ball = kAlone; ball < kCount; ++ball) {
    const std::uint32_t i = ball % 3;
    if (inserters[i].insert(ball, cells[i]) == Insertion::in_use) put_off.push_back(ball);
    for (std::uint8_t k = 0; k < 3; ++k)
      ASSERT_TRUE(may_go_on(store, claims, static_cast<std::uint8_t>(k + 1), cells[k])) << ball;
  }
  EXPECT_GT(put_off.size(), 100u);
  EXPECT_LT(put_off.size(), kCount / 2);
  for (Inserter& inserter : inserters) inserter.end_sharing();
  for (const std::uint32_t ball : put_off)
    EXPECT_EQ(inserters[0].insert(ball, cells[0]), Insertion::added);
  EXPECT_EQ(tetrahedra(store), tetrahedra(expected));
  for (std::uint32_t ball = 0; ball < kCount; ++ball) EXPECT_TRUE(claims.claim(1, ball)) << ball;
}

// In one cell there is room for one inserter only.
TEST(Inserter, LeavesABallWhoseCellIsInUse) {
  std::vector<InsertedBall> balls = some_balls(4);
  balls.push_back({200, 200, 200, 9});
  CellStore store(1000);
  Claims claims(balls.size());
  Inserter first(balls, store), second(balls, store);
  std::uint32_t cell = first.begin({0, 1, 2, 3}), same = cell;
  ASSERT_TRUE(first.begin_sharing(claims, 1, cell));
  ASSERT_TRUE(second.begin_sharing(claims, 2, same));
  EXPECT_EQ(first.insert(4, cell), Insertion::in_use);
  EXPECT_EQ(second.insert(4, same), Insertion::in_use);
  EXPECT_EQ(tetrahedra(store).size(), 1u);
  second.end_sharing();
  EXPECT_EQ(first.insert(4, cell), Insertion::added);
  EXPECT_EQ(tetrahedra(store).size(), 4u);
}

TEST(Claims, AreOfOneInserter) {
  Claims claims(2);
  EXPECT_TRUE(claims.claim(1, 0));
  EXPECT_FALSE(claims.claim(2, 0));
  EXPECT_TRUE(claims.has(1, 0));
  EXPECT_FALSE(claims.has(2, 0));
  EXPECT_FALSE(claims.has(1, 1));
  claims.release(0);
  EXPECT_FALSE(claims.has(1, 0));
  EXPECT_TRUE(claims.claim(2, 0));
}

TEST(Stretches, AreTakenFromTheirBeginAndHelpedFromTheirEnd) {
  Stretches stretches(100, 2);
  const auto expect = [&](std::size_t own, std::uint32_t begin, std::uint32_t end) {
    const Stretches::Range range = stretches.take(own, 30);
    EXPECT_EQ(range.begin, begin);
    EXPECT_EQ(range.end, end);
  };
  expect(0, 0, 30);
  expect(0, 30, 50);
  expect(0, 70, 100);
  expect(1, 50, 70);
  EXPECT_TRUE(stretches.take(1, 30).empty());
  EXPECT_TRUE(stretches.take(0, 30).empty());
}

TEST(Stretches, GiveEachNumberToOneThread) {
  constexpr std::size_t kCount = 100003, kThreads = 4;
  Stretches stretches(kCount, kThreads + 3);
  std::vector<int> seen(kCount, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      while (true) {
        const Stretches::Range range = stretches.take(t, 7);
        if (range.empty()) return;
        for (std::uint32_t n = range.begin; n < range.end; ++n) ++seen[n];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(kCount));
}

}  // namespace
}  // namespace alphascope
