// SPDX-License-Identifier: GPL-3.0-or-later
// Tests spheres that fill cavities against their definition.
#include "core/cavity_shape/filling_spheres.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/clearance/clearance.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/predicates/lifted.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

CavityTable table_of(const BallSet& balls, double solvent_angstrom, double alpha_angstrom2) {
  const auto grown = std::make_shared<const BallSet>(with_solvent(balls, solvent_angstrom));
  const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
      grown, std::make_shared<const Triangulation>(make_triangulation(*grown, 1))));
  return make_cavity_table(ground, {alpha_angstrom2, solvent_angstrom});
}

double least_distance(const BallSet& balls, const RealPoint& x) {
  double least = 1e300;
  const double unit = balls.lattice.unit_angstrom();
  for (BallIndex i = 0; i < balls.size(); ++i) {
    least =
        std::min(least, length(x - unit * real_point(balls.centres[i])) - unit * balls.radii[i]);
  }
  return least;
}

// Uses barycentric coordinates in double precision, so only up to rounding.
bool is_within(const CavityTable& table, const Cavity& cavity, const RealPoint& x) {
  const double unit = table.ground->balls->lattice.unit_angstrom();
  const auto at = [&](BallIndex i) { return unit * real_point(table.ground->balls->centres[i]); };
  return std::any_of(
      cavity.tetrahedra.begin(), cavity.tetrahedra.end(), [&](std::uint32_t tetrahedron) {
        const auto& t = table.ground->triangulation->tetrahedra[tetrahedron];
        const RealPoint p[4] = {at(t[0]), at(t[1]), at(t[2]), at(t[3])};
        const auto six_volumes = [](const RealPoint& a, const RealPoint& b, const RealPoint& c,
                                    const RealPoint& d) { return dot(cross(b - a, c - a), d - a); };
        const double all = six_volumes(p[0], p[1], p[2], p[3]);
        return six_volumes(x, p[1], p[2], p[3]) / all > -1e-9 &&
               six_volumes(p[0], x, p[2], p[3]) / all > -1e-9 &&
               six_volumes(p[0], p[1], x, p[3]) / all > -1e-9 &&
               six_volumes(p[0], p[1], p[2], x) / all > -1e-9;
      });
}

TEST(FillingSpheres, TouchAtomsAndLieInTheCavity) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const Clearance clearance(*balls);
  std::size_t spheres = 0;
  for (const double solvent : {0.0, 0.6, 1.4}) {
    for (const double alpha : {-0.5, 0.0, 2.0}) {
      const CavityTable table = table_of(*balls, solvent, alpha);
      for (std::size_t row = 0; row < table.size(); ++row) {
        const Cavity& cavity = table.cavity(row);
        double last = 1e300;
        for (const FillingSphere& sphere : filling_spheres(*table.ground, cavity, clearance)) {
          const double least = least_distance(*balls, sphere.centre_angstrom);
          ASSERT_NEAR(sphere.radius_angstrom, least, 1e-9);
          ASSERT_TRUE(is_within(table, cavity, sphere.centre_angstrom)) << "row " << row;
          ASSERT_LE(sphere.radius_angstrom, last);
          ASSERT_GT(sphere.radius_angstrom, 0);
          // A centre is rounded by at most half a unit along each axis.
          if (alpha >= 0) {
            ASSERT_GT(sphere.radius_angstrom, solvent - 0.001);
          }
          last = sphere.radius_angstrom;
          ++spheres;
        }
        if (alpha >= 0) {
          EXPECT_LT(last, 1e300) << "row " << row << " has none";
        }
      }
    }
  }
  EXPECT_GT(spheres, 1000u);
}

// Six balls around the origin have four tetrahedra with one orthocentre, so they have one sphere.
TEST(FillingSpheres, FillAHoleKnownByHand) {
  BallSet balls;
  for (const int at : {-4000, 4000}) {
    testing::add_ball(balls, at, 0, 0, 3500);
    testing::add_ball(balls, 0, at, 0, 3500);
    testing::add_ball(balls, 0, 0, at, 3500);
  }
  const CavityTable table = table_of(balls, 0, 0);
  ASSERT_EQ(table.voids, 1u);
  EXPECT_EQ(table.cavity(0).tetrahedra.size(), 4u);
  const auto spheres = filling_spheres(*table.ground, table.cavity(0), Clearance(balls));
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_EQ(spheres[0].centre_angstrom, RealPoint{});
  EXPECT_NEAR(spheres[0].radius_angstrom, 0.5, 1e-12);
  // At alpha = -3 Å² balls have radii of 3.04 Å, and are too small to close the hole.
  const CavityTable open = table_of(balls, 0, -3);
  ASSERT_EQ(open.voids, 0u);
  // With balls of 4.2 Å the hole is filled at alpha 0; at -3 it is there, but no sphere fits.
  for (std::int32_t& radius : balls.radii) radius = 4200;
  const CavityTable covered = table_of(balls, 0, -3);
  ASSERT_EQ(covered.voids, 1u);
  EXPECT_TRUE(filling_spheres(*covered.ground, covered.cavity(0), Clearance(balls)).empty());
}

TEST(FillingSpheres, OfFewerAreStillEverywhere) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz");
  const Clearance clearance(*balls);
  const CavityTable table = table_of(*balls, 1.4, 0);
  const Cavity& cavity = table.cavity(0);
  const auto all = filling_spheres(*table.ground, cavity, clearance);
  ASSERT_GT(all.size(), 1000u);
  for (const std::size_t most : {500u, 100u, 1u, 0u}) {
    const auto some = filling_spheres(*table.ground, cavity, clearance, most);
    EXPECT_LE(some.size(), most);
    EXPECT_GE(4 * some.size(), most);
    if (most > 0) {
      EXPECT_EQ(some.front(), all.front());
    }
    if (most < 500) continue;
    for (const FillingSphere& sphere : all) {
      EXPECT_TRUE(std::any_of(some.begin(), some.end(), [&](const FillingSphere& kept) {
        return kept.radius_angstrom >= sphere.radius_angstrom &&
               length(kept.centre_angstrom - sphere.centre_angstrom) < 2 * sphere.radius_angstrom;
      }));
    }
    for (const FillingSphere& kept : some) {
      EXPECT_NE(std::find(all.begin(), all.end(), kept), all.end());
    }
  }
}

TEST(FillingSpheres, AreTheSameForAnyNumberOfThreads) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz");
  const Clearance clearance(*balls);
  const CavityTable table = table_of(*balls, 1.4, 0);
  const auto with = [&](int threads) {
    return tbb::task_arena(threads).execute(
        [&] { return filling_spheres(*table.ground, table.cavity(0), clearance, 300); });
  };
  const auto alone = with(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(with(threads), alone);
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(filling_spheres(*table.ground, table.cavity(0), clearance, 300, cancel), Cancelled);
}

}  // namespace
}  // namespace alphascope
