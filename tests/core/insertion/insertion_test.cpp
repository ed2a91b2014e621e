// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that inserted triangulations are those of CGAL, with any number of threads.
#include "core/insertion/insertion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/lattice_point.hpp"
#include "core/insertion/insertion_order.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

TEST(Insertion, OfHardSetsEqualsCgals) {
  Random random(51);
  std::size_t compared = 0, flat = 0;
  for (int round = 0; round < 4; ++round) {
    std::vector<NamedBalls> sets = testing::large_hard_sets(random);
    for (NamedBalls& set : testing::small_hard_sets(random, 12)) sets.push_back(std::move(set));
    for (NamedBalls& set : testing::sets_at_the_bounds(random, 200)) sets.push_back(std::move(set));
    for (const NamedBalls& set : sets) {
      const Triangulation expected = make_cgal_triangulation(set.balls, 1);
      const auto found = triangulate_by_insertion(set.balls, 1, {});
      ASSERT_EQ(found.has_value(), expected.dimension == 3) << set.name;
      flat += !found;
      if (!found) continue;
      EXPECT_TRUE(*found == expected) << set.name;
      compared += expected.tetrahedra.size();
    }
  }
  EXPECT_GT(compared, 20000u);
  EXPECT_GT(flat, 10u);
}

// Sets that are large enough for several inserters.
std::vector<NamedBalls> many_balls() {
  const int count = testing::kAddressSanitizer ? 9000 : 20000;
  Random random(52);
  std::vector<NamedBalls> sets;
  sets.push_back({"spread", testing::random_balls(random, count, 500, 1, 30)});
  sets.push_back({"mostly hidden", testing::random_balls(random, count, 500, 1, 900)});
  sets.push_back({"at the bounds", testing::random_balls(random, count, kMaxLatticeCoordinate / 2,
                                                         1, kMaxLatticeRadius)});
  const int side = static_cast<int>(std::cbrt(count));
  NamedBalls lattice{"lattice", {}}, wall{"between walls", {}}, ball{"on a sphere", {}};
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) testing::add_ball(lattice.balls, 10 * x, 10 * y, 10 * z, 7);
    }
  }
  for (int n = 0; n < count / 2; ++n) {
    const int x = testing::random_int(random, 0, 3000), y = testing::random_int(random, 0, 3000);
    testing::add_ball(wall.balls, x, y, 4000 * (n % 2), 5);
  }
  for (int n = 0; n < count / 2; ++n) {
    const double height = 2 * (n + 0.5) / (count / 2) - 1, turn = 2.399963 * n;
    const double across = std::sqrt(1 - height * height);
    testing::add_ball(ball.balls, static_cast<int>(20000 * across * std::cos(turn)),
                      static_cast<int>(20000 * across * std::sin(turn)),
                      static_cast<int>(20000 * height), 100);
  }
  sets.push_back(std::move(lattice));
  sets.push_back(std::move(wall));
  sets.push_back(std::move(ball));
  return sets;
}

TEST(Insertion, TogetherEqualsCgals) {
  std::uint64_t put_off = 0;
  for (const NamedBalls& set : many_balls()) {
    const Triangulation expected = make_cgal_triangulation(set.balls, 1);
    for (const int threads : {2, 3, 7, 16}) {
      InsertionCounts counts;
      const auto found = triangulate_by_insertion(set.balls, threads, {}, &counts);
      EXPECT_TRUE(*found == expected) << set.name << ", threads " << threads;
      EXPECT_GT(counts.inserters, 1u) << set.name;
      put_off += counts.put_off;
    }
  }
  EXPECT_GT(put_off, 100u);
}

// Two lines of balls: each pair of neighbours on the one makes a tetrahedron with each on the
// other. So the tetrahedra need more room than usual.
TEST(Insertion, TakesMoreRoomWhereItMust) {
  for (const int threads : {1, 4}) {
    NamedBalls lines{"lines", {}};
    const int half = 700;
    for (int n = 0; n < half; ++n) {
      testing::add_ball(lines.balls, 100 * n, 0, 0, 3);
      testing::add_ball(lines.balls, 50 * half, 100 * n - 50 * half, 90000, 3);
    }
    const auto found = triangulate_by_insertion(lines.balls, threads, {});
    ASSERT_EQ(found->tetrahedra.size(), static_cast<std::size_t>((half - 1) * (half - 1)));
    EXPECT_TRUE(*found == make_cgal_triangulation(lines.balls, 1)) << threads;
  }
}

TEST(InsertionOrder, HasEachBallOnceInGrowingRounds) {
  Random random(53);
  const BallSet balls = testing::random_balls(random, 30000, 40, 1, 9);
  const std::vector<bool> hidden = coincident_hidden(balls);
  const InsertionOrder order = insertion_order(balls, hidden);
  std::vector<int> seen(balls.size(), 0);
  for (const BallIndex i : order.balls) ++seen[i];
  for (BallIndex i = 0; i < balls.size(); ++i) EXPECT_EQ(seen[i], hidden[i] ? 0 : 1) << i;
  ASSERT_EQ(order.rounds.size(), 3u);
  EXPECT_EQ(order.rounds.back(), order.balls.size());
  EXPECT_GT(order.rounds[0], 100u);
  for (std::size_t r = 1; r < order.rounds.size(); ++r)
    EXPECT_NEAR(static_cast<double>(order.rounds[r]) / static_cast<double>(order.rounds[r - 1]), 8,
                2);
}

// A ball is near the one before it.
TEST(InsertionOrder, FollowsACurveInEachRound) {
  Random random(54);
  const BallSet balls = testing::random_balls(random, 30000, 10000, 1, 9);
  const InsertionOrder order = insertion_order(balls, {});
  double steps = 0;
  const std::size_t begin = order.rounds[1] + 1;
  for (std::size_t n = begin; n < order.balls.size(); ++n)
    steps += std::sqrt(static_cast<double>(
        square_distance(balls.centres[order.balls[n - 1]], balls.centres[order.balls[n]])));
  const double spacing = 20000 / std::cbrt(30000.0);
  EXPECT_LT(steps / static_cast<double>(order.balls.size() - begin), 2 * spacing);
}

}  // namespace
}  // namespace alphascope
