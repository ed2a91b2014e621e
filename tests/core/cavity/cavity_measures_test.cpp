// Numbers of cavities: what must not change them, and sets whose numbers are known by hand.
#include "core/cavity/cavity_measures.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "core/cavity/cavity_depth.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

struct Measured {
  Cavities cavities;
  std::vector<CavityMeasures> measures;
};
Measured measure(const BallSet& balls, double alpha, double solvent_angstrom) {
  const auto shared = std::make_shared<const BallSet>(balls);
  const CavityGround ground = make_cavity_ground(
      shared, std::make_shared<const Triangulation>(make_triangulation(balls, 1)));
  const Membership in =
      membership(balls, *ground.triangulation, ground.incidence, ground.flow, alpha);
  Measured found{find_cavities(ground, in), {}};
  found.measures = measure_cavities(ground, in, found.cavities,
                                    {alpha, balls.lattice.nearest_units(solvent_angstrom)});
  return found;
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(CavityMeasures, AreTheSameBitsForAnyNumberOfThreads) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz", 1.4);
  const auto with = [&](int threads) {
    return tbb::task_arena(threads).execute([&] { return measure(*balls, 0, 1.4).measures; });
  };
  const auto alone = with(1);
  ASSERT_GT(alone.size(), 50u);
  for (const int threads : {2, 3, 8}) {
    const auto other = with(threads);
    ASSERT_EQ(other.size(), alone.size());
    for (std::size_t c = 0; c < alone.size(); ++c) {
      EXPECT_TRUE(same_bits(other[c].volume_sa_angstrom3, alone[c].volume_sa_angstrom3));
      EXPECT_TRUE(same_bits(other[c].area_sa_angstrom2, alone[c].area_sa_angstrom2));
      EXPECT_TRUE(same_bits(other[c].volume_ms_angstrom3, alone[c].volume_ms_angstrom3));
      EXPECT_TRUE(same_bits(other[c].area_ms_angstrom2, alone[c].area_ms_angstrom2));
      EXPECT_EQ(other[c].lining, alone[c].lining);
    }
  }
}

// Equal balls of radius 5 grown by alpha = 9 · 9 - 5 · 5 are balls of radius 9.
TEST(CavityMeasures, GrowingByAlphaIsGrowingEqualBalls) {
  Random random(111);
  std::size_t cavities = 0;
  for (int round = 0; round < 30; ++round) {
    BallSet balls = testing::random_balls(random, 200, 60, 5, 5), large = balls;
    large.radii.assign(large.size(), 9);
    const Measured a = measure(balls, 56, 0), b = measure(large, 0, 0);
    ASSERT_EQ(a.cavities, b.cavities);
    for (std::size_t c = 0; c < a.measures.size(); ++c) {
      EXPECT_NEAR(a.measures[c].volume_sa_angstrom3, b.measures[c].volume_sa_angstrom3, 1e-8);
      EXPECT_NEAR(a.measures[c].area_sa_angstrom2, b.measures[c].area_sa_angstrom2, 1e-8);
      EXPECT_EQ(a.measures[c].lining, b.measures[c].lining);
      ++cavities;
    }
  }
  EXPECT_GT(cavities, 50u);
}

// A cube of side 2 with balls of radius 1 at its corners: all edges are tangent, all faces open.
// What is left of it is 8 - 4/3 pi, and a face of it 4 - pi.
TEST(CavityMeasures, OfACubeOfTangentBalls) {
  BallSet cube;
  for (int n = 0; n < 8; ++n) testing::add_ball(cube, n & 2, n / 2 & 2, 2 * (n & 1), 1);
  cube.lattice.digits = 0;
  const Measured found = measure(cube, 0, 0);
  ASSERT_EQ(found.measures.size(), 1u);
  const CavityMeasures& m = found.measures[0];
  const double pi = std::acos(-1.0);
  EXPECT_EQ(found.cavities.cavities[0].mouths.size(), 6u);
  EXPECT_NEAR(m.volume_of_tetrahedra_angstrom3, 8, 1e-14);
  EXPECT_NEAR(m.volume_sa_angstrom3, 8 - 4 * pi / 3, 1e-14);
  EXPECT_NEAR(m.area_sa_angstrom2, 4 * pi, 1e-14);
  ASSERT_EQ(m.mouths.size(), 6u);
  for (const MouthMeasures& mouth : m.mouths) {
    EXPECT_NEAR(mouth.area_angstrom2, 4 - pi, 1e-14);
    EXPECT_NEAR(mouth.length_angstrom, 2 * pi, 1e-14);
  }
  EXPECT_EQ(m.corners, 0u);
  EXPECT_NEAR(m.arc_length_angstrom, 0, 1e-14);
  EXPECT_EQ(m.lining.size(), 8u);
}

// Volumes by counting points: of voids, where the sum is exact.
TEST(CavityMeasures, OfAVoidAreWhatPointsSay) {
  BallSet cube;
  for (int n = 0; n < 8; ++n) testing::add_ball(cube, 20 * (n & 1), 10 * (n & 2), 5 * (n & 4), 16);
  cube.lattice.digits = 0;
  const Measured found = measure(cube, 0, 0);
  ASSERT_EQ(found.measures.size(), 1u);
  ASSERT_TRUE(found.cavities.cavities[0].is_void());
  // One eighth of the cube, on a lattice of 1/16, at the middles of its cells.
  std::size_t free = 0;
  for (double x = 0.5; x < 160; ++x) {
    for (double y = 0.5; y < 160; ++y) {
      for (double z = 0.5; z < 160; ++z) free += x * x + y * y + z * z > 256 * 256;
    }
  }
  EXPECT_NEAR(found.measures[0].volume_sa_angstrom3, static_cast<double>(free) / 512, 0.2);
  EXPECT_GT(found.measures[0].volume_sa_angstrom3, 5);
}

// Tangent, flat, hidden, at the bounds of the lattice: at alphas where simplices come, too.
TEST(CavityMeasures, AreNumbersForHardSets) {
  Random random(112);
  std::vector<testing::NamedBalls> sets = testing::large_hard_sets(random, 300);
  for (testing::NamedBalls& set : testing::small_hard_sets(random, 12)) sets.push_back(set);
  std::size_t cavities = 0, touching = 0;
  for (const testing::NamedBalls& set : sets) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const CavityGround ground = make_cavity_ground(
        balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1)));
    if (ground.triangulation->dimension < 3) continue;
    std::vector<double> alphas{0, set.alpha_unit()};
    const Filtration filtration(balls, *ground.triangulation);
    const auto& values = filtration.top().triangles.alpha_values;
    for (std::size_t n = 0; n < values.size(); n += values.size() / 8 + 1) {
      alphas.push_back(values[n]);
    }
    for (const double alpha : alphas) {
      const Membership in = membership(filtration, alpha);
      for (const OutsideRule rule : {OutsideRule::castp, OutsideRule::pocket}) {
        const Cavities found = find_cavities(ground, in, rule);
        const auto measures = measure_cavities(ground, in, found, {alpha, 1});
        for (const CavityMeasures& m : measures) {
          ASSERT_TRUE(std::isfinite(m.volume_sa_angstrom3)) << set.name;
          ASSERT_TRUE(std::isfinite(m.volume_ms_angstrom3)) << set.name;
          ASSERT_TRUE(std::isfinite(m.area_ms_angstrom2)) << set.name;
          ASSERT_TRUE(std::isfinite(m.arc_length_angstrom)) << set.name;
          ASSERT_TRUE(std::isfinite(m.all_mouths().area_angstrom2)) << set.name;
          ASSERT_LE(m.volume_sa_angstrom3, m.volume_of_tetrahedra_angstrom3 * (1 + 1e-9));
          touching += m.arc_length_angstrom == 0;
          ++cavities;
        }
      }
    }
  }
  EXPECT_GT(cavities, 1000u);
  EXPECT_GT(touching, 10u);
}

// Against points all over the triangles.
TEST(CavityMeasures, DepthIsTheFarthestAtomsWayToAMouth) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz", 1.4);
  const CavityGround ground = make_cavity_ground(
      balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1)));
  const Membership in = membership(*balls, *ground.triangulation, ground.incidence, ground.flow, 0);
  const Cavities found = find_cavities(ground, in);
  const auto measures = measure_cavities(ground, in, found, {});
  const double unit = balls->lattice.unit_angstrom();
  std::size_t pockets = 0;
  for (std::size_t c = 0; c < found.cavities.size(); ++c) {
    const Cavity& cavity = found.cavities[c];
    const double depth = depth_angstrom(ground, cavity, measures[c].lining);
    if (cavity.is_void() || cavity.mouth_triangles() > 20) {
      EXPECT_EQ(depth > 0, !cavity.is_void());
      continue;
    }
    double deepest = 0;
    for (const BallIndex v : measures[c].lining) {
      double nearest = 1e300;
      for (const Mouth& mouth : cavity.mouths) {
        for (const std::uint32_t f : mouth.triangles) {
          const auto& corner = ground.incidence.triangles[f];
          const BallIndex a = corner[0], b = corner[1], d = corner[2];
          constexpr int kSteps = 40;
          for (int s = 0; s <= kSteps; ++s) {
            for (int t = 0; s + t <= kSteps; ++t) {
              const auto off = [&](std::int32_t LatticePoint::*x) {
                const auto at = [&](BallIndex i) { return double(balls->centres[i].*x); };
                return (s * at(a) + t * at(b) + (kSteps - s - t) * at(d)) / kSteps - at(v);
              };
              nearest = std::min(nearest, std::hypot(off(&LatticePoint::x), off(&LatticePoint::y),
                                                     off(&LatticePoint::z)));
            }
          }
        }
      }
      deepest = std::max(deepest, nearest * unit);
    }
    EXPECT_LE(depth, deepest + 1e-9);
    EXPECT_NEAR(depth, deepest, 0.02);
    ++pockets;
  }
  EXPECT_GT(pockets, 20u);
}

TEST(CavityMeasures, OrderIsByFallingVolume) {
  std::vector<CavityMeasures> measures(4);
  measures[0].volume_sa_angstrom3 = 1;
  measures[1].volume_sa_angstrom3 = 3;
  measures[2].volume_sa_angstrom3 = -1;
  measures[3].volume_sa_angstrom3 = 3;
  EXPECT_EQ(by_falling_volume(measures), (std::vector<std::uint32_t>{1, 3, 0, 2}));
}

}  // namespace
}  // namespace alphascope
