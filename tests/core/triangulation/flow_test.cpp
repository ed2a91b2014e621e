// SPDX-License-Identifier: GPL-3.0-or-later
// Tests through which faces tetrahedra flow, and to which sinks, against rationals.
#include "core/triangulation/flow.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/predicates/perturbation.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/five_balls.hpp"
#include "tests/support/reference/rational_cavities.hpp"

namespace alphascope {
namespace {

using testing::Random;

// Four balls at a time, up to the bounds of the lattice, for filter, integers and perturbation.
TEST(FlowPredicate, IsThatOfRationals) {
  Random random(81);
  std::size_t decided = 0, ties = 0, tied_in = 0;
  for (int n = 0; n < 30000; ++n) {
    // Every third set has few small numbers, so it has ties.
    const BallSet balls = n % 3 == 0 ? testing::random_balls(random, 4, 2, 1, 2)
                                     : testing::five_balls(random, n % testing::kFiveBallKinds);
    const auto seen = [&](BallIndex i, BallIndex k) { return lifted_vector(balls, i, k); };
    const LiftedInt j = seen(0, 1), k = seen(0, 2), l = seen(0, 3);
    if (determinant(j, k, l) == 0) continue;
    signed char beyond[4] = {0, 0, 0, 0};
    if (within_bracket_limit(j) && within_bracket_limit(k) && within_bracket_limit(l)) {
      flow_sides_filtered(
          tetrahedron_centre(lifted_as<double>(j), lifted_as<double>(k), lifted_as<double>(l)),
          beyond);
    }
    for (BallIndex m = 0; m < 4; ++m) {
      const BallIndex abc[3] = {m == 0 ? 1u : 0u, m < 2 ? 2u : 1u, m < 3 ? 3u : 2u};
      const int side = testing::inside_smallest_orthosphere(balls, abc, m);
      const LiftedInt b = seen(abc[0], abc[1]), c = seen(abc[0], abc[2]), d = seen(abc[0], m);
      ASSERT_EQ(flow_side_exact(b, c, d), side) << n;
      ASSERT_TRUE(beyond[m] == 0 || beyond[m] == side) << n;
      decided += beyond[m] != 0;
      if (side != 0) continue;
      ++ties;
      const bool in = testing::inside_perturbed_orthosphere(balls, abc, m) > 0;
      tied_in += in;
      ASSERT_EQ(tied_flow(b, c, d, FlowTies::perturbed), in) << n;
      ASSERT_FALSE(tied_flow(b, c, d, FlowTies::strict));
    }
  }
  EXPECT_GT(decided, 20000u);
  EXPECT_GT(ties, 500u);
  EXPECT_GT(tied_in, 100u);
  EXPECT_GT(ties, tied_in + 100);
}

// Tetrahedra whose orthocentre is within a unit of a face's plane. The filter's error bound must
// not decide there, and must not be too careful beside it. Balls a, b and c lie on a circle around
// the orthocentre's foot. The weight of d moves the orthocentre along the normal.
TEST(FlowPredicate, IsThatOfRationalsNextToAFace) {
  Random random(84);
  std::size_t near = 0, ties = 0, sides[2] = {0, 0}, undecided = 0;
  for (int n = 0; n < 15000; ++n) {
    const int reach = 1 << testing::random_int(random, 2, 24);
    BallSet balls;
    const auto at = [&] { return testing::random_int(random, -reach, reach); };
    for (int m = 0; m < 3; ++m) {
      const int x = at(), y = at(), z = at();
      testing::add_ball(balls, x, y, z, reach);
    }
    // The fourth ball is as far from the circle's centre as the other three, up to rounding. So d
    // is on their smallest sphere, and the side of face abc is decided by a unit or less.
    const auto v = [&](int m) {
      return real_point(balls.centres[m]) - real_point(balls.centres[0]);
    };
    const RealPoint b = v(1), c = v(2);
    const RealPoint normal = cross(b, c);
    if (!(dot(normal, normal) > 0)) continue;
    const RealPoint centre =
        (0.5 / dot(normal, normal)) * (dot(b, b) * cross(c, normal) + dot(c, c) * cross(normal, b));
    const double radius = length(centre);
    const RealPoint direction = unit_vector(RealPoint{1.0 * at(), 1.0 * at(), 1.0 * at() + 0.5});
    const LatticePoint d =
        nearest_lattice_point(real_point(balls.centres[0]) + centre + radius * direction);
    if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > (1 << 27)) continue;
    testing::add_ball(balls, d.x, d.y, d.z, reach + testing::random_int(random, -1, 1));
    const auto seen = [&](BallIndex i, BallIndex k) { return lifted_vector(balls, i, k); };
    const LiftedInt j = seen(0, 1), k = seen(0, 2), l = seen(0, 3);
    if (determinant(j, k, l) == 0) continue;
    signed char beyond[4] = {0, 0, 0, 0};
    if (within_bracket_limit(j) && within_bracket_limit(k) && within_bracket_limit(l)) {
      flow_sides_filtered(
          tetrahedron_centre(lifted_as<double>(j), lifted_as<double>(k), lifted_as<double>(l)),
          beyond);
    }
    for (BallIndex m = 0; m < 4; ++m) {
      const BallIndex abc[3] = {m == 0 ? 1u : 0u, m < 2 ? 2u : 1u, m < 3 ? 3u : 2u};
      const int side = testing::inside_smallest_orthosphere(balls, abc, m);
      ASSERT_EQ(flow_side_exact(seen(abc[0], abc[1]), seen(abc[0], abc[2]), seen(abc[0], m)), side);
      ASSERT_TRUE(beyond[m] == 0 || beyond[m] == side) << n << ", face " << m;
      if (m < 3) continue;
      ++near;
      ties += side == 0;
      undecided += beyond[m] == 0;
      if (side != 0) ++sides[side > 0];
    }
  }
  EXPECT_GT(near, 8000u);
  EXPECT_GT(ties, 3u);
  EXPECT_GT(sides[0], 2000u);
  EXPECT_GT(sides[1], 2000u);
  EXPECT_GT(undecided, 20u);  // ties, and triangles that are nearly flat
  EXPECT_LT(undecided, near * 9 / 10) << "the filter decides hardly anything";
}

TEST(Flow, NeverFallsAndEndsSomewhere) {
  Random random(82);
  std::vector<testing::NamedBalls> sets = testing::large_hard_sets(random);
  sets.push_back({"many", testing::random_balls(random, 2000, 2000, 20, 200)});
  std::size_t both = 0, ties = 0;
  for (const testing::NamedBalls& set : sets) {
    const Triangulation triangulation = make_triangulation(set.balls, 1);
    if (triangulation.dimension < 3) continue;
    const Flow flow = make_flow(set.balls, triangulation, FlowTies::perturbed);
    ties += flow.ties;
    for (std::size_t t = 0; t < flow.marks.size(); ++t) {
      ASSERT_EQ(flow.alpha_values[t], ortho_radius_rounded(set.balls, triangulation.tetrahedra[t]));
      std::uint8_t reached = flow.is_sink(t) ? Flow::kReachesSink : 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (!flow.through(t, k)) continue;
        const Neighbour across = triangulation.neighbours[t][k];
        if (across.is_hull()) {
          reached |= Flow::kReachesInfinity;
        } else {
          ASSERT_GE(flow.alpha_values[across.index()], flow.alpha_values[t]);
          reached |= flow.marks[across.index()] & ~Flow::kFaces;
        }
      }
      ASSERT_EQ(flow.marks[t] & ~Flow::kFaces, reached) << set.name;
      ASSERT_NE(reached, 0);
      both += reached == (Flow::kReachesSink | Flow::kReachesInfinity);
    }
  }
  EXPECT_GT(both, 50u);
  EXPECT_GT(ties, 100u);
}

TEST(Flow, IsTheSameForAnyNumberOfThreads) {
  Random random(83);
  const BallSet balls = testing::random_balls(random, 5000, 3000, 20, 200);
  const Triangulation triangulation = make_triangulation(balls, 1);
  const auto marks = [&](int threads) {
    return tbb::task_arena(threads).execute(
        [&] { return make_flow(balls, triangulation, FlowTies::perturbed).marks; });
  };
  const auto alone = marks(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(marks(threads), alone);
}

}  // namespace
}  // namespace alphascope
