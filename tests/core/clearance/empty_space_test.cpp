// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that queries which search locally give the same answers as the whole complex.
#include "core/clearance/empty_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/lifted.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/flow.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

std::vector<testing::NamedBalls> sets(Random& random) {
  std::vector<testing::NamedBalls> result = testing::small_hard_sets(random, 60);
  for (testing::NamedBalls& set : testing::large_hard_sets(random, 400)) {
    result.push_back(std::move(set));
  }
  for (int n = 0; n < 20; ++n) {
    result.push_back({"random", testing::random_balls(random, 150, 40, 1, 12)});
  }
  return result;
}

TEST(EmptySpace, IsWhatIsNotInTheComplex) {
  Random random(5);
  std::size_t open = 0, closed = 0, open_attached = 0;
  for (const testing::NamedBalls& set : sets(random)) {
    SCOPED_TRACE(set.name);
    const Triangulation triangulation = make_triangulation(set.balls, 1);
    if (triangulation.dimension != 3) continue;
    const Incidence incidence = make_incidence(triangulation);
    const Flow flow = make_flow(set.balls, triangulation, FlowTies::perturbed);
    const Membership in = membership(set.balls, triangulation, incidence, flow, 0);
    const EmptySpace space(set.balls, triangulation);
    for (std::uint32_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
      ASSERT_EQ(space.is_empty(t), !in.tetrahedra[t]);
      if (in.tetrahedra[t]) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        const Neighbour across = triangulation.neighbours[t][k];
        if (!across.is_hull() && in.tetrahedra[across.index()]) continue;
        const std::uint32_t f = incidence.triangles_of_tetrahedron[t][k];
        ASSERT_EQ(space.is_open(t, k), !in.triangles[f]);
        (in.triangles[f] ? closed : open) += 1;
        // An attached triangle is open, whatever its own ortho-radius.
        open_attached += !in.triangles[f] && flow.through(t, k);
      }
    }
  }
  EXPECT_GT(open, 1000u);
  EXPECT_GT(closed, 1000u);
  EXPECT_GT(open_attached, 100u);
}

// Corners of a way have equal power to their four balls, and lie outside all balls.
TEST(EmptySpace, CornersOfAWayAreOutsideTheBalls) {
  Random random(6);
  int ways = 0;
  for (int n = 0; n < 20; ++n) {
    BallSet balls = testing::random_balls(random, 120, 60, 2, 12);
    // An end must lie outside all balls.
    const auto power = [&](BallIndex i, const RealPoint& x) {
      const RealPoint d = x - real_point(balls.centres[i]);
      return dot(d, d) - static_cast<double>(balls.weight(i));
    };
    const LatticePoint end{testing::random_int(random, -30, 30),
                           testing::random_int(random, -30, 30),
                           testing::random_int(random, -30, 30)};
    bool outside = true;
    for (BallIndex i = 0; i < balls.size(); ++i) outside &= power(i, real_point(end)) > 0;
    if (!outside) continue;
    balls.centres.push_back(end);
    balls.radii.push_back(0);
    const auto from = static_cast<BallIndex>(balls.size() - 1);
    const Triangulation triangulation = make_triangulation(balls, 1);
    const EmptySpace space(balls, triangulation);
    const auto way = space.cheapest_way(from, EmptySpace::kOutside, {1, 100, from}, {});
    if (!way) continue;
    ++ways;
    for (const std::uint32_t t : *way) {
      const RealPoint corner = space.corner(t);
      const double own = power(triangulation.tetrahedra[t][0], corner);
      EXPECT_GT(own, 0);
      for (BallIndex i = 0; i < balls.size(); ++i) {
        EXPECT_GE(power(i, corner), own - 1e-6 * (1 + std::fabs(own)));
      }
    }
  }
  EXPECT_GT(ways, 5);
}

// Integrates ds / clearance² along the segment between two corners, by the midpoint rule. The
// clearance is the distance to a ball with the face's largest radius and the point's power, plus
// the growth of the balls.
double integrated(const BallSet& balls, const std::array<BallIndex, 3>& face, const RealPoint& from,
                  const RealPoint& to, const WayCost& cost) {
  constexpr int kSteps = 5000;
  double radius = 0, sum = 0;
  for (const BallIndex i : face) radius = std::max(radius, static_cast<double>(balls.radii[i]));
  for (int n = 0; n < kSteps; ++n) {
    const RealPoint at = from + (n + 0.5) / kSteps * (to - from);
    const RealPoint d = at - real_point(balls.centres[face[0]]);
    const double power = dot(d, d) - static_cast<double>(balls.weight(face[0]));
    const double outside = std::sqrt(std::max(0.0, power) + radius * radius) - radius;
    const double clearance = std::min(outside + cost.grown, cost.enough);
    sum += 1 / (clearance * clearance);
  }
  return sum * length(to - from) / kSteps;
}

TEST(EmptySpace, AWayCostsItsLengthByTheSquareOfItsClearance) {
  Random random(7);
  int faces = 0;
  for (int n = 0; n < 10; ++n) {
    const BallSet balls = testing::random_balls(random, 100, 60, 2, 12);
    const Triangulation triangulation = make_triangulation(balls, 1);
    const EmptySpace space(balls, triangulation);
    const WayCost cost{0.5, 20, static_cast<BallIndex>(balls.size())};
    for (std::uint32_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Neighbour across = triangulation.neighbours[t][k];
        if (across.is_hull() || !space.is_empty(t) || !space.is_empty(across.index())) continue;
        if (!space.is_open(t, k)) continue;
        const double expected = integrated(balls, space.face(t, k), space.corner(t),
                                           space.corner(across.index()), cost);
        EXPECT_NEAR(space.cost_across(t, k, cost), expected, 0.35 * expected + 1e-12);
        ++faces;
      }
    }
  }
  EXPECT_GT(faces, 300);
}

}  // namespace
}  // namespace alphascope
