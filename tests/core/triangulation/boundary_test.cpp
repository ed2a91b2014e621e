// SPDX-License-Identifier: GPL-3.0-or-later
// Tests boundaries of complexes: closed, oriented, separate for each solid, and around the volume
// of its tetrahedra.
#include "core/triangulation/boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;

AlphaComplex complex_of(const BallSet& balls, double alpha) {
  return make_cpu_engine(std::make_shared<const BallSet>(balls))->compute({alpha, false}, {});
}

double volume(const BallSet& balls, const Boundary& b, const BoundarySolid& solid) {
  double six = 0;
  for (std::uint32_t n = 0; n < solid.triangles; ++n) {
    const auto& t = b.triangles[solid.first_triangle + n];
    const auto at = [&](std::size_t k) { return place_angstrom(balls, b.vertices[t[k]]); };
    six += dot(at(0), cross(at(1), at(2)));
  }
  return six / 6;
}

double volume_of_tetrahedra(const BallSet& balls, const AlphaComplex& complex) {
  double six = 0;
  for (const auto& t : complex.tetrahedra.simplices) {
    const RealPoint a = real_point(balls.centres[t[0]]);
    const auto from = [&](std::size_t k) { return real_point(balls.centres[t[k]]) - a; };
    six += std::fabs(dot(from(1), cross(from(2), from(3))));
  }
  return six / 6 * std::pow(balls.lattice.unit_angstrom(), 3);
}

// Each side occurs once in each direction, each vertex has one fan, and no two solids share a
// vertex.
::testing::AssertionResult is_manifold(const Boundary& b) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> after;  // side to its triangle
  for (std::uint32_t f = 0; f < b.triangles.size(); ++f) {
    for (std::size_t n = 0; n < 3; ++n) {
      const std::pair side(b.triangles[f][n], b.triangles[f][(n + 1) % 3]);
      if (side.first == side.second) return ::testing::AssertionFailure() << "a side of length 0";
      if (!after.emplace(side, f).second) return ::testing::AssertionFailure() << "a side twice";
    }
  }
  std::map<std::uint32_t, std::size_t> corners, fans;
  for (const auto& t : b.triangles) {
    for (const std::uint32_t v : t) ++corners[v];
  }
  if (corners.size() != b.vertices.size()) {
    return ::testing::AssertionFailure() << "a vertex of no triangle";
  }
  std::set<std::uint32_t> begun;
  for (const auto& [side, first] : after) {
    if (!begun.insert(side.first).second) continue;
    std::pair<std::uint32_t, std::uint32_t> spoke = side;
    do {
      const auto back = after.find({spoke.second, spoke.first});
      if (back == after.end()) return ::testing::AssertionFailure() << "an open side";
      const auto& t = b.triangles[back->second];
      std::size_t n = 0;
      while (t[n] != spoke.first) ++n;
      spoke.second = t[(n + 1) % 3];
    } while (++fans[spoke.first] <= corners[spoke.first] && spoke != side);
    if (fans[side.first] != corners[side.first]) {
      return ::testing::AssertionFailure() << "two fans around one vertex";
    }
  }
  std::uint32_t vertices = 0, triangles = 0;
  for (const BoundarySolid& solid : b.solids) {
    if (solid.first_vertex != vertices || solid.first_triangle != triangles) {
      return ::testing::AssertionFailure() << "solids do not follow one another";
    }
    vertices += solid.vertices;
    triangles += solid.triangles;
    for (std::uint32_t n = solid.first_triangle; n < triangles; ++n) {
      for (const std::uint32_t v : b.triangles[n]) {
        if (v < solid.first_vertex || v >= vertices) {
          return ::testing::AssertionFailure() << "a vertex of another solid";
        }
      }
    }
  }
  return ::testing::AssertionSuccess();
}

std::size_t middles(const Boundary& b) {
  std::size_t count = 0;
  for (const BoundaryVertex& vertex : b.vertices) count += vertex.ball != vertex.other;
  return count;
}

void expect_right(const BallSet& balls, const AlphaComplex& complex) {
  const Boundary b = make_boundary(balls, complex.tetrahedra.simplices);
  EXPECT_TRUE(is_manifold(b));
  std::size_t regular = 0, tetrahedra = 0;
  for (const SimplexClass c : complex.triangles.classes) regular += c == SimplexClass::regular;
  EXPECT_EQ(b.triangles.size(), regular + 2 * middles(b));
  double sum = 0, last = std::numeric_limits<double>::infinity();
  for (const BoundarySolid& solid : b.solids) {
    tetrahedra += solid.tetrahedra;
    const double own = solid.volume_cubic_units * std::pow(balls.lattice.unit_angstrom(), 3);
    EXPECT_NEAR(volume(balls, b, solid), own, 1e-9 * own + 1e-9);
    EXPECT_LE(own, last);
    last = own;
    sum += own;
  }
  EXPECT_EQ(tetrahedra, complex.tetrahedra.size());
  const double whole = volume_of_tetrahedra(balls, complex);
  EXPECT_NEAR(sum, whole, 1e-9 * whole + 1e-9);
}

TEST(Boundary, OfMoleculesIsClosedAroundTheirTetrahedra) {
  std::size_t touching = 0;
  for (const double solvent : {0.0, 1.4}) {
    const auto balls = testing::sample_balls("4hhb.pdb.gz", solvent);
    for (const double alpha : {-1.0, 0.0, 1.4, 3.0, 1000.0}) {
      SCOPED_TRACE("solvent " + std::to_string(solvent) + " alpha " + std::to_string(alpha));
      const AlphaComplex complex = complex_of(*balls, alpha);
      expect_right(*balls, complex);
      touching += middles(make_boundary(*balls, complex.tetrahedra.simplices));
    }
  }
  EXPECT_GT(touching, 10u);  // some solids touch themselves along an edge
}

TEST(Boundary, OfHardSetsIsClosed) {
  testing::Random random(7);
  for (const auto& [name, balls, unit] : testing::large_hard_sets(random, 300)) {
    for (const double factor : {0.5, 4.0, 1e6}) {
      SCOPED_TRACE(name);
      const AlphaComplex complex = complex_of(balls, factor * unit);
      const Boundary b = make_boundary(balls, complex.tetrahedra.simplices);
      EXPECT_TRUE(is_manifold(b));
    }
  }
}

// Tetrahedra that share an edge, and some that share only a vertex.
TEST(Boundary, SolidsThatTouchHaveTheirOwnVertices) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const int at : {0, 1, 2})
    add_ball(balls, at == 0 ? 10 : 0, at == 1 ? 10 : 0, at == 2 ? 10 : 0, 1);
  add_ball(balls, 0, 0, 0, 1);     // 3: the first one's corner
  add_ball(balls, -10, 0, 0, 1);   // 4
  add_ball(balls, -9, -10, 1, 1);  // 5
  add_ball(balls, -9, 1, -10, 1);  // 6
  const Simplices<4> at_a_vertex{{0, 1, 2, 3}, {3, 4, 5, 6}};
  const Boundary b = make_boundary(balls, at_a_vertex);
  EXPECT_TRUE(is_manifold(b));
  EXPECT_EQ(b.solids.size(), 2u);
  EXPECT_EQ(b.vertices.size(), 8u);
  const Simplices<4> at_an_edge{{0, 1, 2, 3}, {2, 3, 4, 5}};
  const Boundary c = make_boundary(balls, at_an_edge);
  EXPECT_TRUE(is_manifold(c));
  EXPECT_EQ(c.solids.size(), 2u);
  EXPECT_EQ(c.triangles.size(), 8u);
  EXPECT_EQ(c.vertices.size(), 8u);
}

TEST(Boundary, OfNothingIsNothing) {
  const Boundary b = make_boundary({}, {});
  EXPECT_TRUE(b.vertices.empty());
  EXPECT_TRUE(b.solids.empty());
}

TEST(Boundary, IsCancelled) {
  const auto balls = testing::sample_balls("1crn.pdb");
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(make_boundary(*balls, complex_of(*balls, 3).tetrahedra.simplices, context),
               Cancelled);
}

}  // namespace
}  // namespace alphascope
