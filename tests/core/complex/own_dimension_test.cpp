// SPDX-License-Identifier: GPL-3.0-or-later
// Tests classes and counts in a plane, on a line and at a point against the definition in
// rationals.
#include "core/complex/own_dimension.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/document/explain/dimension_words.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::Random;

BallSet balls_at(const std::vector<std::array<int, 4>>& xyzr) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& [x, y, z, r] : xyzr) testing::add_ball(balls, x, y, z, r);
  return balls;
}

AlphaComplex computed(const BallSet& balls, double alpha) {
  return make_cpu_engine(std::make_shared<const BallSet>(balls), {1})->compute({alpha}, {});
}

template <int N>
void expect_classes(const SimplexList<N>& found, const SimplexList<N>& expected) {
  ASSERT_EQ(found.simplices, expected.simplices);
  EXPECT_EQ(found.classes, expected.classes) << "of " << N << " balls";
}

// Compares at each alpha value, where the complex changes.
void expect_as_defined(const BallSet& balls, int dimension) {
  const testing::RationalOracle oracle(balls);
  ASSERT_EQ(dimension_of_centres(balls), dimension);
  ASSERT_EQ(oracle.dimension(), dimension);
  for (const auto& [simplex, value] : oracle.alpha_values()) {
    // An alpha not below the value, and on every lattice.
    const double alpha = std::ceil(value.get_d() * 64) / 64;
    const AlphaComplex complex = computed(balls, alpha);
    const InOwnDimension own(balls, complex);
    const AlphaComplex expected = oracle.own_complex(alpha);
    expect_classes(own.complex().vertices, expected.vertices);
    expect_classes(own.complex().edges, expected.edges);
    expect_classes(own.complex().triangles, expected.triangles);
    expect_classes(own.complex().tetrahedra, expected.tetrahedra);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(OwnDimension, ClassesAreThoseOfTheDefinition) {
  expect_as_defined(balls_at({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}, {2, 2, 0, 1}}), 2);
  // Cocircular balls in a plane other than z = 0.
  expect_as_defined(balls_at({{5, 0, 5, 2},
                              {3, 4, 3, 2},
                              {0, 5, 0, 2},
                              {-3, 4, -3, 2},
                              {-5, 0, -5, 2},
                              {0, -5, 0, 2},
                              {0, 0, 0, 1}}),
                    2);
  expect_as_defined(balls_at({{0, 0, 0, 1}, {3, 6, 9, 2}, {1, 2, 3, 1}, {5, 10, 15, 4}}), 1);
  expect_as_defined(balls_at({{1, 2, 3, 4}}), 0);
  expect_as_defined(balls_at({{1, 2, 3, 4}, {1, 2, 3, 5}}), 0);
  Random random(31);
  for (int round = 0; round < 6; ++round) {
    BallSet balls = testing::random_balls(random, 8, 6, 1, 4);
    for (LatticePoint& p : balls.centres) p.z = p.x - 2 * p.y;
    expect_as_defined(balls, 2);
    expect_as_defined(testing::random_balls(random, 7, 6, 1, 4), 3);
  }
}

// A square filled around its middle. One vertex and four edges are interior.
TEST(OwnDimension, AFilledNeighbourhoodInThePlaneIsInterior) {
  const BallSet balls =
      balls_at({{0, 0, 0, 1}, {4, 0, 0, 1}, {0, 4, 0, 1}, {-4, 0, 0, 1}, {0, -4, 0, 1}});
  const AlphaComplex complex = computed(balls, 100);
  EXPECT_EQ(class_counts(complex)[1], (ClassCounts{0, 8, 0})) << "in space";
  const InOwnDimension own(balls, complex);
  EXPECT_EQ(class_counts(own.complex())[0], (ClassCounts{0, 4, 1}));
  EXPECT_EQ(class_counts(own.complex())[1], (ClassCounts{0, 4, 4}));
  EXPECT_EQ(class_counts(own.complex())[2], (ClassCounts{0, 0, 4}));
  EXPECT_EQ(own.complex().hash, complex.hash);
}

TEST(OwnDimension, IsTheComplexItselfInSpaceAndForTetrahedraOnly) {
  Random random(33);
  const BallSet balls = testing::random_balls(random, 9, 6, 1, 4);
  const AlphaComplex complex = computed(balls, 100);
  EXPECT_EQ(&InOwnDimension(balls, complex).complex(), &complex);
  const BallSet flat = balls_at({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}});
  AlphaComplex nothing;
  nothing.tetrahedra_only = true;
  EXPECT_EQ(class_counts(InOwnDimension(flat, nothing).complex()), class_counts(nothing));
  EXPECT_EQ(InOwnDimension(BallSet{}, AlphaComplex{}).dimension(), -1);
}

TEST(OwnDimension, CountsAreInItsWords) {
  const auto text = [](const BallSet& balls) {
    return own_counts_text(balls, computed(balls, 100));
  };
  EXPECT_EQ(text(balls_at({{0, 0, 7, 2}, {2, 0, 7, 2}, {0, 2, 7, 2}, {2, 2, 7, 2}, {0, 0, 7, 1}})),
            "In the plane: 4 of 5 centres, 5 edges (4 on the boundary, 1 interior, 0 singular), 2 "
            "triangles, Euler number 1");
  EXPECT_EQ(text(balls_at({{0, 0, 0, 1}, {3, 3, 3, 1}, {6, 6, 6, 1}})),
            "On the line: 3 of 3 centres (2 on the boundary, 1 interior, 0 singular), 2 edges, "
            "Euler number 1");
  EXPECT_EQ(text(balls_at({{4, 4, 4, 1}})), "At the point: 1 of 1 centre");
  EXPECT_EQ(text(BallSet{}), "");
  EXPECT_EQ(text(balls_at({{0, 0, 0, 1}, {3, 0, 0, 1}, {0, 3, 0, 1}, {0, 0, 3, 1}})), "");
}

}  // namespace
}  // namespace alphascope
