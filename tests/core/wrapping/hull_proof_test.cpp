// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the proof of a hull accepts CGAL's triangulations and finds hulls that are open,
// dented or doubled.
#include "core/wrapping/hull_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;

TEST(HullProof, AcceptsCgalsHulls) {
  Random random(94);
  int proven = 0;
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    SCOPED_TRACE(set.name);
    const Triangulation whole = make_triangulation(set.balls, 1);
    if (whole.dimension < 3) continue;
    EXPECT_TRUE(encloses_once(set.balls, whole));
    ++proven;
  }
  EXPECT_GT(proven, 20);
}

class HullFault : public ::testing::Test {
 protected:
  HullFault() {
    Random random(95);
    balls_ = testing::random_balls(random, 60, 400, 20, 200);
    whole_ = make_triangulation(balls_, 1);
    EXPECT_TRUE(encloses_once(balls_, whole_));
  }
  BallSet balls_;
  Triangulation whole_;
};

TEST_F(HullFault, AMissingFacetIsFound) {
  whole_.hull.pop_back();
  EXPECT_FALSE(encloses_once(balls_, whole_));
}

TEST_F(HullFault, ATurnedFacetIsFound) {
  std::swap(whole_.hull[3].balls[1], whole_.hull[3].balls[2]);
  EXPECT_FALSE(encloses_once(balls_, whole_));
}

TEST_F(HullFault, TwiceTheHullIsFound) {
  const std::vector<HullFacet> hull = whole_.hull;
  whole_.hull.insert(whole_.hull.end(), hull.begin(), hull.end());
  EXPECT_FALSE(encloses_once(balls_, whole_));
}

// A second closed surface, far from the ray, is found since it is not around the first tetrahedron.
TEST_F(HullFault, AnotherBodyIsFound) {
  BallSet both = balls_;
  const auto shift = static_cast<BallIndex>(balls_.size());
  for (std::size_t n = 0; n < balls_.size(); ++n) {
    const LatticePoint& p = balls_.centres[n];
    testing::add_ball(both, p.x + 5000, p.y, p.z, balls_.radii[n]);
  }
  EXPECT_TRUE(encloses_once(both, whole_));
  for (HullFacet facet : std::vector<HullFacet>(whole_.hull)) {
    for (BallIndex& i : facet.balls) i += shift;
    whole_.hull.push_back(facet);
  }
  EXPECT_FALSE(encloses_once(both, whole_));
}

// Three facets replace one, over a ball that is behind it.
TEST_F(HullFault, ADentIsFound) {
  const HullFacet facet = whole_.hull[2];
  const auto& t = whole_.tetrahedra[facet.tetrahedron];
  const BallIndex inner = *std::find_if(t.begin(), t.end(), [&](BallIndex i) {
    return std::count(facet.balls.begin(), facet.balls.end(), i) == 0;
  });
  whole_.hull.erase(whole_.hull.begin() + 2);
  for (int n = 0; n < 3; ++n)
    whole_.hull.push_back({{facet.balls[n], facet.balls[(n + 1) % 3], inner}, facet.tetrahedron});
  EXPECT_FALSE(encloses_once(balls_, whole_));
}

}  // namespace
}  // namespace alphascope
