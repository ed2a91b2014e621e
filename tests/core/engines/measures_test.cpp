// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that areas, volumes and cavities follow from the complex, so that every engine gives the
// same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope::testing {
namespace {

class EngineMeasures : public EngineSuite {};
INSTANTIATE_TEST_SUITE_P(Engines, EngineMeasures, ::testing::ValuesIn(engines()), engine_name);

constexpr double kNear = 1e-12;  // relative

void expect_same_bits(const UnionMeasures& found, const UnionMeasures& expected) {
  EXPECT_EQ(found.total, expected.total);
  EXPECT_EQ(found.of_ball, expected.of_ball);
}

// A device rounds differently. Errors are relative to a whole ball, since little of it may be left.
void expect_near(const UnionMeasures& found, const UnionMeasures& expected,
                 const std::vector<double>& spheres) {
  EXPECT_NEAR(found.area_angstrom2(), expected.area_angstrom2(), kNear * expected.area_angstrom2());
  EXPECT_NEAR(found.volume_angstrom3(), expected.volume_angstrom3(),
              kNear * expected.volume_angstrom3());
  ASSERT_EQ(found.ball_area_angstrom2().size(), expected.ball_area_angstrom2().size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    EXPECT_NEAR(found.ball_area_angstrom2()[i], expected.ball_area_angstrom2()[i],
                kNear * spheres[i]);
    const double ball = spheres[i] * std::sqrt(spheres[i] / (36 * std::acos(-1.0)));
    EXPECT_NEAR(found.ball_volume_angstrom3()[i], expected.ball_volume_angstrom3()[i],
                kNear * ball);
  }
}

TEST_P(EngineMeasures, AreThoseOfEveryEngine) {
  Random random(12);
  int compared = 0;
  for (const NamedBalls& set : large_hard_sets(random, std::min(60, GetParam().most_balls))) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    for (const double factor : {0.0, 0.5, 2.0}) {
      const double alpha = factor * set.alpha_unit();
      if (!GetParam().affords(*balls, alpha)) continue;
      SCOPED_TRACE(set.name + ", alpha " + std::to_string(alpha));
      const auto engine = GetParam().make(balls);
      const AlphaComplex found = engine->compute({alpha}, {});
      const AlphaComplex expected = make_cgal_engine(balls, {1})->compute({alpha}, {});
      const UnionMeasures of_cgal = measure_union(*balls, expected, {1});
      expect_same_bits(measure_union(*balls, found, {1}), of_cgal);
      WorkThreads threads(1);
      if (const auto by = measure_on_device(*engine, *balls, found, threads, {})) {
        const bool beyond_limits = found.engine.route.find("limits") != std::string::npos;
        EXPECT_EQ(by->note.empty(), !beyond_limits) << by->note;
        expect_near(by->measures, of_cgal, free_areas_angstrom2(*balls, found.alpha_on_lattice));
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

template <int N, class Simplex>
bool holds(const SimplexList<N>& list, const Simplex& simplex) {
  return std::binary_search(list.simplices.begin(), list.simplices.end(), simplex);
}

// Cavities are found in the triangulation of all balls, and fit the complex of every engine. It has
// none of their tetrahedra, no mouth, and all walls of voids.
TEST_P(EngineMeasures, CavitiesFitTheComplexOfEveryEngine) {
  Random random(13);
  std::size_t cavities = 0;
  for (const NamedBalls& set : large_hard_sets(random, std::min(60, GetParam().most_balls))) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
        balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1, {})),
        FlowTies::perturbed, {}));
    for (const double factor : {0.0, 0.5}) {
      const double alpha = factor * set.alpha_unit();
      if (!GetParam().affords(*balls, alpha)) continue;
      SCOPED_TRACE(set.name + ", alpha " + std::to_string(alpha));
      const AlphaComplex complex = GetParam().make(balls)->compute({alpha}, {});
      const CavityTable table = make_cavity_table(ground, {alpha, 0}, {});
      const Incidence& incidence = ground->incidence;
      for (std::size_t row = 0; row < table.size(); ++row, ++cavities) {
        const Cavity& cavity = table.cavity(row);
        for (const std::uint32_t t : cavity.tetrahedra) {
          EXPECT_FALSE(holds(complex.tetrahedra, ground->triangulation->tetrahedra[t]));
          for (const std::uint32_t f : incidence.triangles_of_tetrahedron[t]) {
            const auto [a, b] = incidence.tetrahedra_of_triangle[f];
            const auto inside = [&](std::uint32_t of) {
              return of != Incidence::kOutside &&
                     table.found.cavity_of_tetrahedron[of] == table.order[row];
            };
            const bool is_wall = cavity.is_void() && !(inside(a) && inside(b));
            if (!is_wall) continue;
            EXPECT_TRUE(holds(complex.triangles, incidence.triangles[f]));
          }
        }
        for (const Mouth& mouth : cavity.mouths) {
          for (const std::uint32_t f : mouth.triangles) {
            EXPECT_FALSE(holds(complex.triangles, incidence.triangles[f]));
          }
        }
      }
    }
  }
  EXPECT_GT(cavities, 0u);
}

}  // namespace
}  // namespace alphascope::testing
