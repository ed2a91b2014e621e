// SPDX-License-Identifier: GPL-3.0-or-later
// Tests measures of the union clipped to tetrahedra.
#include "core/measure/exact_outside.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/convex_piece.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/core/measure/measured_sets.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::balls_of_file;
using testing::measured;
using testing::Random;
using testing::random_balls;

ExactTetrahedra measure_all_exactly(const BallSet& balls, double alpha_angstrom2 = 0,
                                    int threads = 1) {
  const Triangulation triangulation = make_triangulation(balls, 1);
  std::vector<std::uint32_t> all(triangulation.tetrahedra.size());
  std::iota(all.begin(), all.end(), 0u);
  return exact_outside(triangulation, balls, balls.lattice.alpha_on_lattice(alpha_angstrom2), all,
                       threads);
}
double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Balls in a box with a small ball at each corner. All tetrahedra together are the box. It contains
// the union but for seven octants of each small ball.
struct Boxed {
  BallSet balls;
  double volume, free_volume, area;  // Å³, Å³, Å²
};
Boxed boxed(const BallSet& balls, int half_width, int corner_radius) {
  Boxed box;
  box.balls = balls;
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) {
        add_ball(box.balls, x * half_width, y * half_width, z * half_width, corner_radius);
      }
    }
  }
  const UnionMeasures of = measured(box.balls);
  const double width = balls.lattice.angstrom(2.0 * half_width),
               radius = balls.lattice.angstrom(corner_radius);
  box.volume = width * width * width;
  box.free_volume = box.volume - (of.volume_angstrom3() - 7 * ball_volume(radius));
  box.area = of.area_angstrom2() - 7 * sphere_area(radius);
  return box;
}
void expect_boxed(const BallSet& balls, const std::string& name) {
  double reach = 1;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    for (const int x : {p.x, p.y, p.z}) {
      reach = std::max(reach, std::fabs(x) + static_cast<double>(balls.radii[i]));
    }
  }
  const Boxed box = boxed(balls, static_cast<int>(3 * reach), static_cast<int>(reach));
  const ExactTetrahedra of = measure_all_exactly(box.balls);
  EXPECT_NEAR(sum(of.volume_angstrom3), box.volume, 1e-12 * box.volume) << name;
  EXPECT_NEAR(sum(of.free_volume_angstrom3), box.free_volume, 1e-11 * box.volume) << name;
  EXPECT_NEAR(sum(of.area_angstrom2), box.area, 1e-11 * box.area) << name;
  for (const double free_volume : of.free_volume_angstrom3) {
    EXPECT_GE(free_volume, -1e-12 * box.volume) << name;
  }
}

TEST(ExactTetrahedra, OfABoxAreItsComplementOfTheUnion) {
  Random random(21);
  for (int n = 0; n < 15; ++n) {
    BallSet balls = random_balls(random, 60, 2000, 300, 1800);
    balls.lattice.digits = 3;
    expect_boxed(balls, "random");
  }
}

TEST(ExactTetrahedra, OfABoxAroundHardSetsAreItsComplementOfTheUnion) {
  Random random(22);
  int sets = 0;
  for (const auto& [name, balls, unit] : testing::small_hard_sets(random, 60)) {
    double reach = 1;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const LatticePoint& p = balls.centres[i];
      reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) + balls.radii[i];
    }
    if (reach > 1e6) continue;  // no room for the box
    expect_boxed(balls, name);
    ++sets;
  }
  EXPECT_GT(sets, 10);
}

TEST(ExactTetrahedra, AreTheSameBitsForAnyThreads) {
  const BallSet balls = with_solvent(balls_of_file("1crn.xyzr"), 1.4);
  const ExactTetrahedra one = measure_all_exactly(balls, 0.5, 1),
                        four = measure_all_exactly(balls, 0.5, 4);
  EXPECT_EQ(one.free_volume_angstrom3, four.free_volume_angstrom3);
  EXPECT_EQ(one.area_angstrom2, four.area_angstrom2);
}

// Single tetrahedra into which other balls reach, also where no corner's cell does.
TEST(ExactTetrahedra, AgreeWithSampling) {
  Random random(23);
  std::uniform_real_distribution<double> uniform(1e-300, 1);
  for (int n = 0; n < 4; ++n) {
    const BallSet balls = random_balls(random, 60, 100, 10, 70);
    const Triangulation triangulation = make_triangulation(balls, 1);
    const ExactTetrahedra of = measure_all_exactly(balls, n - 2.0);
    for (std::size_t t = 0; t < triangulation.tetrahedra.size(); t += 3) {
      constexpr int kPoints = 1500;
      int free = 0;
      for (int p = 0; p < kPoints; ++p) {
        double weight[4], all = 0, at[3] = {};
        for (double& w : weight) all += w = -std::log(uniform(random));
        for (int m = 0; m < 4; ++m) {
          const LatticePoint& c = balls.centres[triangulation.tetrahedra[t][m]];
          at[0] += weight[m] / all * c.x, at[1] += weight[m] / all * c.y,
              at[2] += weight[m] / all * c.z;
        }
        bool is_free = true;
        for (std::size_t i = 0; i < balls.size() && is_free; ++i) {
          const LatticePoint& c = balls.centres[i];
          const double x = at[0] - c.x, y = at[1] - c.y, z = at[2] - c.z;
          is_free = x * x + y * y + z * z >=
                    static_cast<double>(balls.weight(static_cast<BallIndex>(i))) + n - 2.0;
        }
        free += is_free;
      }
      const double whole = of.volume_angstrom3[t];
      EXPECT_NEAR(of.free_volume_angstrom3[t] / whole, static_cast<double>(free) / kPoints, 0.07);
    }
  }
}

TEST(ExactTetrahedra, RefuseWrongIndices) {
  const BallSet balls = balls_of_file("1crn.xyzr");
  const Triangulation triangulation = make_triangulation(balls, 1);
  const std::vector<std::uint32_t> beyond = {
      static_cast<std::uint32_t>(triangulation.tetrahedra.size())};
  EXPECT_THROW(exact_outside(triangulation, balls, 0, beyond), std::invalid_argument);
  EXPECT_TRUE(exact_outside(triangulation, balls, 0, {}).volume_angstrom3.empty());
}

// A cube of half width 2, cut from a tetrahedron, with a ball of radius 2.5 in it.
TEST(ConvexPiece, OfACubeSharesSixCapsLess) {
  const Vector3<double> corner[4] = {{20, 20, 20}, {20, -20, -20}, {-20, 20, -20}, {-20, -20, 20}};
  const double s = 1 / std::sqrt(3.0), h = 20 * s;
  const PieceFace face[4] = {
      {{-s, -s, -s}, h, 9}, {{-s, s, s}, h, 9}, {{s, -s, s}, h, 9}, {{s, s, -s}, h, 9}};
  ConvexPiece piece;
  const double mirrored = dot(Vector3<double>{0, -40, -40},
                              cross(Vector3<double>{-40, 0, -40}, Vector3<double>{-40, -40, 0}));
  piece.start(corner, face, mirrored < 0);
  EXPECT_NEAR(piece.volume(), 64000.0 / 3, 1e-9);
  std::uint32_t made_by = 0;
  for (const int sign : {-1, 1}) {
    EXPECT_TRUE(piece.cut({3.0 * sign, 0, 0}, 6, made_by++));
    EXPECT_TRUE(piece.cut({0, 1.0 * sign, 0}, 2, made_by++));
    EXPECT_TRUE(piece.cut({0, 0, 7.0 * sign}, 14, made_by++));
  }
  EXPECT_NEAR(piece.volume(), 64, 1e-12);
  std::uint32_t seen = 0;
  piece.for_faces([&](std::uint32_t by) { seen |= 1u << by; });
  EXPECT_EQ(seen, 63u);
  const SharedMeasures shared = piece.shared_with_ball(2.5);
  EXPECT_NEAR(shared.area, sphere_area(2.5) - 6 * cap_area(2.5, 0.5), 1e-12);
  EXPECT_NEAR(shared.volume, ball_volume(2.5) - 6 * cap_volume(2.5, 0.5), 1e-12);
  EXPECT_NEAR(piece.shared_with_ball(5).volume, 64, 1e-12);
  EXPECT_NEAR(piece.shared_with_ball(5).area, 0, 1e-12);
  EXPECT_NEAR(piece.shared_with_ball(1).volume, ball_volume(1), 1e-12);
  EXPECT_FALSE(piece.cut({1, 1, 1}, -7, 7));
}

}  // namespace
}  // namespace alphascope
