// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the proof of a triangulation notices every kind of damage.
#include "core/verify/verify_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/lattice_point.hpp"
#include "core/insertion/order_tetrahedra.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

bool says(const Verification& verification, const std::string& what) {
  return std::any_of(verification.messages.begin(), verification.messages.end(),
                     [&](const std::string& m) { return m.find(what) != std::string::npos; });
}

BallSet unit_balls(const std::vector<LatticePoint>& centres) {
  BallSet balls;
  balls.lattice.digits = 0;
  balls.centres = centres;
  balls.radii.assign(centres.size(), 1);
  return balls;
}

// Any tetrahedra, with the neighbours and hull that follow from them. So only the tetrahedra can be
// wrong.
Triangulation made_of(const BallSet& balls, const Simplices<4>& tetrahedra) {
  UnorderedTetrahedra all;
  for (std::uint32_t a = 0; a < tetrahedra.size(); ++a) {
    const auto& of_a = tetrahedra[a];
    TetrahedronCorners corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = {of_a[k], TetrahedronCorner::kOutside};
    for (std::uint32_t b = 0; b < tetrahedra.size(); ++b) {
      std::array<BallIndex, 4> only_a;
      const auto& of_b = tetrahedra[b];
      const auto end =
          std::set_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), only_a.begin());
      if (end != only_a.begin() + 1) continue;
      const auto corner = std::find(of_a.begin(), of_a.end(), only_a[0]) - of_a.begin();
      corners[static_cast<std::size_t>(corner)] = {only_a[0], b};
    }
    all.tetrahedra.push_back(corners);
  }
  Triangulation result;
  result.dimension = 3;
  set_tetrahedra(balls, all, {}, result);
  set_vertices(balls.size(), {}, result);
  return result;
}

class DamagedTriangulation : public ::testing::Test {
 protected:
  DamagedTriangulation() {
    Random random(41);
    balls_ = testing::random_balls(random, 200, 100, 10, 60);
    triangulation_ = make_triangulation(balls_, 1);
  }

  void expect_noticed(const std::string& what, const std::function<void(Triangulation&)>& damage) {
    Triangulation damaged = triangulation_;
    damage(damaged);
    const Verification verification = verify_triangulation(balls_, damaged);
    EXPECT_FALSE(verification.ok()) << what;
    EXPECT_TRUE(says(verification, what))
        << what
        << ", but it says: " << (verification.messages.empty() ? "" : verification.messages[0]);
  }

  BallSet balls_;
  Triangulation triangulation_;
};

TEST_F(DamagedTriangulation, NothingIsWrongWithoutIt) {
  ASSERT_GT(triangulation_.hidden.size(), 10u);
  const Verification verification = verify_triangulation(balls_, triangulation_);
  EXPECT_TRUE(verification.ok()) << verification.messages.at(0);
  EXPECT_GT(verification.checks, 5 * triangulation_.tetrahedra.size());
}

TEST_F(DamagedTriangulation, InAListIsNoticed) {
  expect_noticed("out of order",
                 [](Triangulation& t) { std::swap(t.tetrahedra[3], t.tetrahedra[4]); });
  expect_noticed("out of order", [](Triangulation& t) { t.tetrahedra.back()[3] = 9999; });
  expect_noticed("dimension", [](Triangulation& t) { t.dimension = 2; });
  expect_noticed("triangles, but", [](Triangulation& t) { t.triangles.push_back({0, 1, 2}); });
  expect_noticed("each ball once", [](Triangulation& t) { t.hidden.pop_back(); });
  expect_noticed("not listed as a vertex", [](Triangulation& t) {
    t.hidden.push_back(t.vertices.back());
    t.vertices.pop_back();
    std::sort(t.hidden.begin(), t.hidden.end());
  });
  expect_noticed("not listed as hidden", [](Triangulation& t) {
    t.vertices.push_back(t.hidden.back());
    t.hidden.pop_back();
    std::sort(t.vertices.begin(), t.vertices.end());
  });
  expect_noticed("a neighbour is wrong",
                 [](Triangulation& t) { std::swap(t.neighbours[7][0], t.neighbours[7][1]); });
  expect_noticed("four for each", [](Triangulation& t) { t.neighbours.pop_back(); });
  expect_noticed("as many facets", [](Triangulation& t) { t.hull.pop_back(); });
  expect_noticed("counterclockwise",
                 [](Triangulation& t) { std::swap(t.hull[2].balls[1], t.hull[2].balls[2]); });
  expect_noticed("another tetrahedron's", [](Triangulation& t) { ++t.hull[2].tetrahedron; });
  expect_noticed("not a facet", [](Triangulation& t) { t.hull[2].balls[1] = 4000000000u; });
  expect_noticed("a neighbour is wrong", [](Triangulation& t) {
    t.neighbours[7][0] = Neighbour::tetrahedron(Neighbour::kMostIndex);
  });
  expect_noticed("a neighbour is wrong", [](Triangulation& t) {
    t.neighbours[t.hull[0].tetrahedron].fill(Neighbour::hull_facet(Neighbour::kMostIndex));
  });
  expect_noticed("out of order there", [](Triangulation& t) { std::swap(t.hull[2], t.hull[3]); });
}

TEST_F(DamagedTriangulation, AHoleIsNoticed) {
  Simplices<4> fewer = triangulation_.tetrahedra;
  fewer.erase(fewer.begin() + 40);
  EXPECT_TRUE(says(verify_triangulation(balls_, made_of(balls_, fewer)), "not convex"));
}

// A triangulation of all balls but one that should be a vertex.
TEST_F(DamagedTriangulation, ABallThatIsNotHiddenIsNoticed) {
  BallSet fewer = balls_;
  BallIndex last = triangulation_.vertices.back();  // by index, so somewhere inside
  fewer.centres.resize(last);
  fewer.radii.resize(last);
  const Simplices<4> without = make_triangulation(fewer, 1).tetrahedra;
  EXPECT_TRUE(verify_triangulation(fewer, made_of(fewer, without)).ok());
  fewer.centres.push_back(balls_.centres[last]);
  fewer.radii.push_back(balls_.radii[last]);
  EXPECT_TRUE(says(verify_triangulation(fewer, made_of(fewer, without)), "would be a vertex"));
}

TEST(VerifyTriangulation, WantsTheFirstOfEqualBalls) {
  const BallSet balls =
      unit_balls({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 0, 4}, {0, 0, 4}});
  EXPECT_TRUE(verify_triangulation(balls, made_of(balls, {{0, 1, 2, 3}})).ok());
  EXPECT_TRUE(says(verify_triangulation(balls, made_of(balls, {{0, 1, 2, 4}})), "go before it"));
}

TEST(VerifyTriangulation, NoticesASecondLayer) {
  const BallSet balls = unit_balls(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  const Triangulation twice = made_of(balls, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  EXPECT_TRUE(says(verify_triangulation(balls, twice), "overlaps another"));
}

TEST(VerifyTriangulation, NoticesAFold) {
  const BallSet balls = unit_balls({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 7}});
  const Triangulation folded = made_of(balls, {{0, 1, 2, 3}, {0, 1, 2, 4}});
  EXPECT_TRUE(says(verify_triangulation(balls, folded), "same side"));
  const Triangulation thrice = made_of(balls, {{0, 1, 2, 3}, {0, 1, 2, 4}, {1, 2, 3, 4}});
  EXPECT_FALSE(verify_triangulation(balls, thrice).ok());
  const BallSet flat = unit_balls({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {1, 1, 7}});
  const Triangulation with_flat = made_of(flat, {{0, 1, 2, 3}, {0, 1, 2, 4}});
  EXPECT_TRUE(says(verify_triangulation(flat, with_flat), "flat"));
}

// Five balls have two triangulations: one of two tetrahedra and one of three.
TEST(VerifyTriangulation, NoticesTheOtherOfTwoTriangulations) {
  const BallSet balls = unit_balls({{9, 0, 0}, {-5, 8, 0}, {-5, -8, 0}, {0, 0, 3}, {0, 0, -3}});
  const Triangulation two = made_of(balls, {{0, 1, 2, 3}, {0, 1, 2, 4}});
  const Triangulation three = made_of(balls, {{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  EXPECT_TRUE(says(verify_triangulation(balls, two), "not regular"));
  EXPECT_TRUE(verify_triangulation(balls, three).ok());
}

// The corners of a cube are on one sphere, so without the perturbation every triangulation is
// regular, the mirrored one too.
TEST(VerifyTriangulation, NoticesTiesBrokenOtherwise) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (int n = 0; n < 8; ++n) testing::add_ball(balls, n & 1, n >> 1 & 1, n >> 2, 1);
  const Triangulation right = make_triangulation(balls, 1);
  EXPECT_TRUE(verify_triangulation(balls, right).ok());
  Simplices<4> mirrored = right.tetrahedra;
  for (auto& t : mirrored) {
    for (BallIndex& v : t) v ^= 1;
    std::sort(t.begin(), t.end());
  }
  ASSERT_NE(made_of(balls, mirrored).tetrahedra, right.tetrahedra);
  EXPECT_TRUE(says(verify_triangulation(balls, made_of(balls, mirrored)), "not regular"));
}

TEST(VerifyTriangulation, NoticesTheOtherDiagonalInAPlane) {
  const BallSet balls = unit_balls({{0, 0, 1}, {2, 2, 1}, {0, 2, 1}, {2, 0, 1}});
  const Triangulation right = make_triangulation(balls, 1);
  EXPECT_TRUE(verify_triangulation(balls, right).ok());
  Triangulation wrong = right;
  const Simplices<3> one{{0, 1, 2}, {0, 1, 3}}, other{{0, 2, 3}, {1, 2, 3}};
  ASSERT_TRUE(right.triangles == one || right.triangles == other);
  wrong.triangles = right.triangles == one ? other : one;
  EXPECT_TRUE(says(verify_triangulation(balls, wrong), "not regular"));
  wrong.triangles.pop_back();
  EXPECT_FALSE(verify_triangulation(balls, wrong).ok());
}

TEST(VerifyTriangulation, NoticesWhatIsWrongOnALineAndAtAPoint) {
  const BallSet line = unit_balls({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  Triangulation edges = make_triangulation(line, 1);
  EXPECT_TRUE(verify_triangulation(line, edges).ok());
  edges.edges = {{0, 2}};
  edges.vertices = {0, 2};
  edges.hidden = {1};
  EXPECT_TRUE(says(verify_triangulation(line, edges), "would be a vertex"));
  edges.edges = {{0, 1}, {0, 2}};
  edges.vertices = {0, 1, 2};
  edges.hidden = {};
  EXPECT_TRUE(says(verify_triangulation(line, edges), "same side"));

  const BallSet point = unit_balls({{1, 1, 1}, {1, 1, 1}});
  Triangulation vertex = make_triangulation(point, 1);
  EXPECT_TRUE(verify_triangulation(point, vertex).ok());
  std::swap(vertex.vertices, vertex.hidden);
  EXPECT_TRUE(says(verify_triangulation(point, vertex), "not the first"));
  vertex.vertices = {};
  vertex.hidden = {0, 1};
  EXPECT_TRUE(says(verify_triangulation(point, vertex), "all centres are one point"));
  std::swap(vertex.vertices, vertex.hidden);
  EXPECT_TRUE(says(verify_triangulation(point, vertex), "all centres are one point"));
}

TEST(VerifyTriangulation, CanBeCancelled) {
  Random random(42);
  const BallSet balls = testing::random_balls(random, 300, 1000, 50, 100);
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(verify_triangulation(balls, make_triangulation(balls, 1), context), Cancelled);
}

}  // namespace
}  // namespace alphascope
