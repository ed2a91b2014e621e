// SPDX-License-Identifier: GPL-3.0-or-later
// Tests derivatives of area and volume.
#include <gtest/gtest.h>

#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_geometry.hpp"
#include "tests/core/measure/measured_sets.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::balls_of_file;
using testing::measured;
using testing::Random;
using testing::random_balls;

struct Both {
  UnionMeasures measures;
  UnionDerivatives derivatives;
};
Both derived(const BallSet& balls, double alpha_angstrom2 = 0) {
  Both both;
  both.measures = measured(balls, alpha_angstrom2, {1, &both.derivatives});
  return both;
}

// Spheres of radii 5 and 4 at distance 6, by hand: 12 h = 36 + 25 - 16.
TEST(UnionDerivatives, OfTwoBallsAreKnown) {
  BallSet balls;
  balls.lattice.digits = 0;
  add_ball(balls, 0, 0, 0, 5);
  add_ball(balls, 6, 0, 0, 4);
  const UnionDerivatives of = derived(balls).derivatives;
  const double h = 45.0 / 12, h2 = 27.0 / 12;
  // The derivative of V by distance is the disc that opens.
  EXPECT_NEAR(of.volume_by_centre_angstrom2[1].x, kPi * (25 - h * h), 1e-12);
  EXPECT_NEAR(of.volume_by_centre_angstrom2[0].x, -kPi * (25 - h * h), 1e-12);
  EXPECT_NEAR(of.volume_by_radius_angstrom2[0], 2 * kPi * 5 * (5 + h), 1e-12);
  // A = 2 pi (5 (5 + h) + 4 (4 + h2)), with dh/dd = 1 - h/d, dh2/dd = 1 - h2/d.
  const double by_distance = 2 * kPi * (5 * (1 - h / 6) + 4 * (1 - h2 / 6));
  EXPECT_NEAR(of.area_by_centre_angstrom[1].x, by_distance, 1e-12);
  EXPECT_NEAR(of.area_by_centre_angstrom[0].x, -by_distance, 1e-12);
  // dh/dR = R/d, dh2/dR = -R/d.
  const double by_radius = 2 * kPi * (5 + h + 5 + 5 * 5.0 / 6 - 4 * 5.0 / 6);
  EXPECT_NEAR(of.area_by_radius_angstrom[0], by_radius, 1e-12);
  EXPECT_NEAR(of.area_by_centre_angstrom[1].y, 0, 1e-12);
}

// Invariants: all forces and torques sum to zero, and V and A are homogeneous of degree 3 and 2.
void expect_euler(const BallSet& balls, const std::string& name) {
  const Both of = derived(balls);
  const auto check = [&](const std::vector<Gradient>& force, const std::vector<double>& by_radius,
                         double degree, double value) {
    double sum[3] = {}, torque[3] = {}, scaling = 0, size = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const LatticePoint& p = balls.centres[i];
      const double x = balls.lattice.angstrom(p.x), y = balls.lattice.angstrom(p.y),
                   z = balls.lattice.angstrom(p.z), r = balls.lattice.angstrom(balls.radii[i]);
      const Gradient& g = force[i];
      sum[0] += g.x, sum[1] += g.y, sum[2] += g.z;
      torque[0] += y * g.z - z * g.y, torque[1] += z * g.x - x * g.z,
          torque[2] += x * g.y - y * g.x;
      scaling += x * g.x + y * g.y + z * g.z + r * by_radius[i];
      size += std::fabs(x * g.x) + std::fabs(y * g.y) + std::fabs(z * g.z) +
              r * std::fabs(by_radius[i]);
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(torque[k], 0, 1e-11 * size) << name;
      EXPECT_NEAR(sum[k] * balls.lattice.angstrom(1000), 0, 1e-9 * size) << name;
    }
    EXPECT_NEAR(scaling, degree * value, 1e-11 * size) << name;
  };
  check(of.derivatives.volume_by_centre_angstrom2, of.derivatives.volume_by_radius_angstrom2, 3,
        of.measures.volume_angstrom3());
  check(of.derivatives.area_by_centre_angstrom, of.derivatives.area_by_radius_angstrom, 2,
        of.measures.area_angstrom2());
}

TEST(UnionDerivatives, AreThoseOfAHomogeneousMeasure) {
  expect_euler(balls_of_file("1crn.xyzr"), "1crn");
  expect_euler(with_solvent(balls_of_file("1crn.xyzr"), 1.4), "1crn, solvent 1.4");
  Random random(11);
  for (int n = 0; n < 20; ++n) {
    BallSet balls = random_balls(random, 60, 3000, 300, 2000);
    balls.lattice.digits = 3;
    expect_euler(balls, "random");
  }
}

// Central differences with a step of `kStep` lattice units of 1e-6 Å.
TEST(UnionDerivatives, AgreeWithDifferences) {
  constexpr int kStep = 20;
  Random random(12);
  for (int n = 0; n < 12; ++n) {
    BallSet balls = random_balls(random, 12, 2000000, 800000, 2000000);
    balls.lattice.digits = 6;
    const double alpha = n % 3 - 1 == 0 ? 0 : 0.3 * (n % 3 - 1);
    const UnionDerivatives of = derived(balls, alpha).derivatives;
    const auto slope = [&](auto&& move) {
      BallSet up = balls, down = balls;
      move(up, kStep);
      move(down, -kStep);
      const UnionMeasures a = measured(up, alpha), b = measured(down, alpha);
      const double width = 2e-6 * kStep;
      return std::pair((a.area_angstrom2() - b.area_angstrom2()) / width,
                       (a.volume_angstrom3() - b.volume_angstrom3()) / width);
    };
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const auto x = slope([&](BallSet& s, int by) { s.centres[i].x += by; });
      const auto z = slope([&](BallSet& s, int by) { s.centres[i].z += by; });
      const auto r = slope([&](BallSet& s, int by) { s.radii[i] += by; });
      EXPECT_NEAR(of.area_by_centre_angstrom[i].x, x.first, 2e-4) << n << ' ' << i;
      EXPECT_NEAR(of.area_by_centre_angstrom[i].z, z.first, 2e-4) << n << ' ' << i;
      EXPECT_NEAR(of.area_by_radius_angstrom[i], r.first, 2e-4) << n << ' ' << i;
      EXPECT_NEAR(of.volume_by_centre_angstrom2[i].x, x.second, 2e-4) << n << ' ' << i;
      EXPECT_NEAR(of.volume_by_centre_angstrom2[i].z, z.second, 2e-4) << n << ' ' << i;
      EXPECT_NEAR(of.volume_by_radius_angstrom2[i], r.second, 2e-4) << n << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace alphascope
