// SPDX-License-Identifier: GPL-3.0-or-later
// Tests numbers of cavities: changes that must not affect them, and sets with known numbers.
#include "core/cavity/cavity_measures.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "core/cavity/cavity_depth.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
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

// Balls of radius 5 grown by alpha = 9 · 9 - 5 · 5 are balls of radius 9.
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

// A cube of side 2 with balls of radius 1 at its corners. All edges are tangent and all faces open.
// The space left in the cube is 8 - 4/3 pi, and in a face 4 - pi.
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

// Compares volumes of voids, whose sum is exact, with counts of points.
TEST(CavityMeasures, OfAVoidAreWhatPointsSay) {
  BallSet cube;
  for (int n = 0; n < 8; ++n) testing::add_ball(cube, 20 * (n & 1), 10 * (n & 2), 5 * (n & 4), 16);
  cube.lattice.digits = 0;
  const Measured found = measure(cube, 0, 0);
  ASSERT_EQ(found.measures.size(), 1u);
  ASSERT_TRUE(found.cavities.cavities[0].is_void());
  // Counts one eighth of the cube, at the centres of cells of a lattice of 1/16.
  std::size_t free = 0;
  for (double x = 0.5; x < 160; ++x) {
    for (double y = 0.5; y < 160; ++y) {
      for (double z = 0.5; z < 160; ++z) free += x * x + y * y + z * z > 256 * 256;
    }
  }
  EXPECT_NEAR(found.measures[0].volume_sa_angstrom3, static_cast<double>(free) / 512, 0.2);
  EXPECT_GT(found.measures[0].volume_sa_angstrom3, 5);
}

// Tangent, flat and hidden balls, also at the bounds of the lattice, and at alphas where simplices
// appear.
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

// Compares with points all over the triangles.
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

// Eight balls of radius 16 are at the corners of a cube of side 20. Each has a patch of its sphere
// around the middle of the cube, bounded by three planes at distance 10. From the ball at the
// origin these are x = 10, y = 10 and z = 10. The corners of its patch are (10, 10, z) and so on,
// with z = sqrt(56).
struct VoidInACube {
  double half = 10, radius = 16, z = std::sqrt(56.0);
  double arc_radius = std::sqrt(156.0);
  double arc_angle = std::atan2(half, z) - std::atan2(z, half);
  // By Gauss and Bonnet. The planes' circles bend by half / radius for each radian. At a corner the
  // boundary turns by the angle between the planes' normals in the tangent plane.
  double patch() const {
    const double pi = std::acos(-1.0);
    const double turn = std::acos(-half * half / (radius * radius - half * half));
    return radius * radius * (2 * pi - 3 * turn + 3 * arc_angle * half / radius);
  }
  // An eighth of the cube, less the cones from the ball's centre over its patch and over its parts
  // of the discs.
  double volume() const {
    const double disc = arc_radius * arc_radius * arc_angle / 2 + half * z;
    return 8 * (half * half * half - (radius * patch() + 3 * half * disc) / 3);
  }
  // The solid angle of the four centres of a face, from the point above its middle.
  double corner() const { return 4 * std::asin(half * half / (half * half + z * z)); }
  double psi() const { return std::asin(half / radius); }
  double volume_ms(double s) const {
    const double share = 1 - s / radius;
    const double tube = s * s * arc_radius * psi() / 2 - s * s * s * half / radius / 3;
    return volume() + 8 * patch() * radius * (1 - share * share * share) / 3 +
           24 * arc_angle * tube + 6 * corner() * s * s * s / 3;
  }
  double tube_area(double s, double angle) const {
    return 24 * arc_angle * s * (arc_radius * angle - s * std::sin(angle));
  }
  double area_ms_steiner(double s) const {
    const double share = 1 - s / radius;
    return 8 * patch() * share * share + tube_area(s, psi()) + 6 * corner() * s * s;
  }
  double area_ms(double s) const {  // across the axes counts as positive
    const double across = s > arc_radius ? tube_area(s, std::acos(arc_radius / s)) : 0;
    return area_ms_steiner(s) - 2 * across;
  }
};

BallSet cube_of(int side, int radius) {
  BallSet cube;
  for (int n = 0; n < 8; ++n) {
    testing::add_ball(cube, side * (n & 1), side * (n / 2 & 1), side * (n / 4), radius);
  }
  cube.lattice.digits = 0;
  return cube;
}

TEST(CavityMeasures, OfWhatTheProbeReachesAreThoseOfClosedForms) {
  const VoidInACube right;
  for (const double s : {0.0, 3.0, 13.0}) {
    const Measured found = measure(cube_of(20, 16), 0, s);
    ASSERT_EQ(found.measures.size(), 1u);
    const CavityMeasures& m = found.measures[0];
    EXPECT_NEAR(m.volume_sa_angstrom3, right.volume(), 1e-9);
    EXPECT_NEAR(m.area_sa_angstrom2, 8 * right.patch(), 1e-9);
    EXPECT_NEAR(m.arc_length_angstrom, 12 * right.arc_radius * right.arc_angle, 1e-9);
    EXPECT_NEAR(m.volume_ms_angstrom3, right.volume_ms(s), 1e-9) << s;
    EXPECT_NEAR(m.area_ms_steiner_angstrom2, right.area_ms_steiner(s), 1e-9) << s;
    EXPECT_NEAR(m.area_ms_angstrom2, right.area_ms(s), 1e-9) << s;
  }
  EXPECT_GT(right.area_ms(13) - right.area_ms_steiner(13), 0.1) << "no arc meets itself";
}

// With a solvent radius above all radii, patches, arcs and corners fill all space around the void.
TEST(CavityMeasures, AProbeLargerThanAllBallsReachesTheirCentres) {
  for (const double s : {17.0, 40.0}) {
    const Measured found = measure(cube_of(20, 16), 0, s);
    ASSERT_EQ(found.measures.size(), 1u);
    EXPECT_NEAR(found.measures[0].volume_ms_angstrom3, 8000, 1e-9);
    EXPECT_NEAR(found.measures[0].area_ms_angstrom2, 0, 1e-9);
    EXPECT_NEAR(found.measures[0].area_ms_steiner_angstrom2, 0, 1e-9);
  }
}

// A closed box of balls of radius 5, hollow inside.
BallSet box_of_balls() {
  BallSet box;
  for (int x = 0; x <= 8; ++x) {
    for (int y = 0; y <= 8; ++y) {
      for (int z = 0; z <= 8; ++z) {
        const bool shell = x % 8 == 0 || y % 8 == 0 || z % 8 == 0;
        if (shell) testing::add_ball(box, 5 * x, 5 * y, 5 * z, 5);
      }
    }
  }
  box.lattice.digits = 0;
  return box;
}

// The probe has radius 4. Balls in a void that are smaller than it do not keep it out of any place.
TEST(CavityMeasures, BallsSmallerThanTheProbeDoNotKeepItOut) {
  const Measured empty = measure(box_of_balls(), 0, 4);
  ASSERT_EQ(empty.measures.size(), 1u);
  const std::vector<std::vector<LatticePoint>> clusters{
      {{20, 20, 20}},                              // one
      {{20, 20, 20}, {23, 20, 20}},                // two that overlap
      {{20, 20, 20}, {22, 20, 20}, {20, 22, 20}},  // three
      {{20, 20, 20}, {23, 20, 20}, {26, 21, 20}, {14, 20, 20}}};
  for (const std::vector<LatticePoint>& cluster : clusters) {
    for (const std::int32_t radius : {2, 3}) {
      BallSet balls = box_of_balls();
      for (const LatticePoint& p : cluster) testing::add_ball(balls, p.x, p.y, p.z, radius);
      const Measured found = measure(balls, 0, 4);
      ASSERT_EQ(found.measures.size(), 1u);
      const CavityMeasures &m = found.measures[0], &without = empty.measures[0];
      EXPECT_LT(m.volume_sa_angstrom3, without.volume_sa_angstrom3 - 30);
      EXPECT_GT(m.area_sa_angstrom2, without.area_sa_angstrom2 + 40);
      EXPECT_NEAR(m.volume_ms_angstrom3, without.volume_ms_angstrom3, 1e-8)
          << cluster.size() << " of radius " << radius;
      EXPECT_NEAR(m.area_ms_angstrom2, without.area_ms_angstrom2, 1e-8);
      EXPECT_NEAR(m.area_ms_steiner_angstrom2, without.area_ms_steiner_angstrom2, 1e-8);
    }
  }
}

// Two balls on one axis in a void have an arc that is a circle, so all bodies are of revolution. A
// small ball and a large one meet. The probe reaches the small ball's part up to its centre, and
// the triangle between the arc and the centres. It also reaches a shell of the large ball. Volumes
// are summed over slices.
TEST(CavityMeasures, ASmallBallOnALargeOneIsFilledUpToItsCentre) {
  const double s = 4, large = 7, small = 3;
  const Measured empty = measure(box_of_balls(), 0, s);
  for (const int apart : {5, 6, 9}) {
    BallSet balls = box_of_balls();
    testing::add_ball(balls, 18, 20, 20, static_cast<int>(large));
    testing::add_ball(balls, 18 + apart, 20, 20, static_cast<int>(small));
    const Measured found = measure(balls, 0, s);
    ASSERT_EQ(found.measures.size(), 1u);
    // Points within both balls' union that are farther than s from the outside. The nearest outside
    // point lies in the half-plane of the point itself.
    const double x0 = (apart * apart + large * large - small * small) / (2.0 * apart);
    const double r = std::sqrt(large * large - x0 * x0);
    const auto from_outside = [&](double x, double y) {
      // If the point lies in the cone over a sphere's patch, the nearest outside point is on that
      // sphere. Otherwise it is on the arc.
      const bool of_large = y * x0 > x * r || (x < 0 && y >= 0);
      const bool of_small = y * (apart - x0) > (apart - x) * r || x > apart;
      const double to_arc = std::hypot(x - x0, y - r);
      if (of_large && x <= x0) return large - std::hypot(x, y);
      if (of_small && x >= x0) return small - std::hypot(x - apart, y);
      return to_arc;
    };
    double out_of_reach = 0;
    constexpr double kStep = 0.01;
    for (double x = -large + kStep / 2; x < apart + small; x += kStep) {
      for (double y = kStep / 2; y < large; y += kStep) {
        const bool within = std::hypot(x, y) < large || std::hypot(x - apart, y) < small;
        if (within && from_outside(x, y) > s) out_of_reach += 2 * std::acos(-1.0) * y;
      }
    }
    out_of_reach *= kStep * kStep;
    EXPECT_NEAR(empty.measures[0].volume_ms_angstrom3 - found.measures[0].volume_ms_angstrom3,
                out_of_reach, 0.5)
        << apart;
    EXPECT_GT(out_of_reach, 50);
  }
}

TEST(CavityTable, SumsAreOfAllVoidsOrOfAllPockets) {
  const auto balls = testing::sample_balls("4hhb.pdb.gz", 1.4);
  const CavityTable table = make_cavity_table(
      std::make_shared<const CavityGround>(make_cavity_ground(
          balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1)))),
      {0, 1.4});
  double volume[2]{}, area[2]{};
  std::size_t count[2]{}, mouths = 0;
  for (std::size_t c = 0; c < table.found.cavities.size(); ++c) {
    const bool is_void = table.found.cavities[c].is_void();
    ++count[is_void];
    mouths += table.found.cavities[c].mouths.size();
    volume[is_void] += table.measures[c].volume_sa_angstrom3;
    area[is_void] += table.measures[c].area_sa_angstrom2;
  }
  EXPECT_EQ(table.pockets, count[false]);
  EXPECT_EQ(table.voids, count[true]);
  EXPECT_EQ(table.mouths, mouths);
  for (const bool is_void : {false, true}) {
    ASSERT_GT(count[is_void], 1u);
    ASSERT_GT(volume[is_void], 1);
    EXPECT_NEAR(table.volume_sa_angstrom3(is_void), volume[is_void], 1e-9 * volume[is_void]);
    EXPECT_NEAR(table.area_sa_angstrom2(is_void), area[is_void], 1e-9 * area[is_void]);
  }
}

TEST(CavityMeasures, OrderIsByFallingVolume) {
  // Two equal boxes side by side, and a smaller one. Among equal boxes the first is that whose
  // deepest sink has the first centres, in any order of the balls.
  BallSet balls;
  for (const auto& [at, length] : std::vector<std::pair<int, int>>{{400, 5}, {0, 6}, {200, 6}}) {
    for (int x = 0; x <= length; ++x) {
      for (int y = 0; y <= 4; ++y) {
        for (int z = 0; z <= 4; ++z) {
          const bool shell = x == 0 || x == length || y % 4 == 0 || z % 4 == 0;
          if (shell) testing::add_ball(balls, at + 4 * x, 4 * y, 4 * z, 4);
        }
      }
    }
  }
  balls.lattice.digits = 0;
  BallSet reversed = balls;
  std::reverse(reversed.centres.begin(), reversed.centres.end());
  for (const BallSet& set : {balls, reversed}) {
    const auto ground =
        make_cavity_ground(std::make_shared<const BallSet>(set),
                           std::make_shared<const Triangulation>(make_triangulation(set, 1)));
    const Membership in = membership(set, *ground.triangulation, ground.incidence, ground.flow, 0);
    const Cavities found = find_cavities(ground, in);
    std::vector<CavityMeasures> measures = measure_cavities(ground, in, found, {0, 0});
    std::vector<std::pair<double, std::int32_t>> voids;
    for (const std::uint32_t c : by_falling_volume(ground, found, measures)) {
      if (!found.cavities[c].is_void()) continue;
      const auto& sink = ground.triangulation->tetrahedra[found.cavities[c].deepest_sink];
      voids.emplace_back(measures[c].volume_sa_angstrom3, set.centres[sink[0]].x / 200);
    }
    ASSERT_EQ(voids.size(), 3u);
    EXPECT_TRUE(same_bits(voids[0].first, voids[1].first));
    EXPECT_LT(voids[2].first, voids[1].first);
    EXPECT_EQ(voids[0].second, 0);
    EXPECT_EQ(voids[1].second, 1);
    EXPECT_EQ(voids[2].second, 2);
  }
}

// All numbers of all cavities, keyed by the centres of their deepest sinks.
std::map<std::vector<LatticePoint>, std::vector<double>> numbers_by_place(const BallSet& balls,
                                                                          double solvent) {
  const auto ground = std::make_shared<const CavityGround>(
      make_cavity_ground(std::make_shared<const BallSet>(balls),
                         std::make_shared<const Triangulation>(make_triangulation(balls, 1))));
  const CavityTable table = make_cavity_table(ground, {0, solvent});
  const std::vector<ExactCavityMeasures> clipped = measure_all_exactly(table);
  std::map<std::vector<LatticePoint>, std::vector<double>> numbers;
  for (std::size_t row = 0; row < table.size(); ++row) {
    std::vector<LatticePoint> sink;
    for (const BallIndex v : table.sink(row)) sink.push_back(balls.centres[v]);
    std::sort(sink.begin(), sink.end());
    const CavityMeasures& m = table.measure(row);
    const MouthMeasures mouths = m.all_mouths();
    const ExactCavityMeasures& exact = clipped[table.order[row]];
    numbers[sink] = {static_cast<double>(row),
                     m.volume_sa_angstrom3,
                     m.area_sa_angstrom2,
                     m.volume_ms_angstrom3,
                     m.area_ms_angstrom2,
                     m.area_ms_steiner_angstrom2,
                     m.volume_of_tetrahedra_angstrom3,
                     m.arc_length_angstrom,
                     static_cast<double>(m.corners),
                     static_cast<double>(m.lining.size()),
                     mouths.area_angstrom2,
                     mouths.length_angstrom,
                     exact.volume_sa_angstrom3,
                     exact.area_sa_angstrom2};
  }
  return numbers;
}

TEST(CavityMeasures, AreTheSameBitsInWhateverOrderTheBallsAre) {
  Random random(114);
  std::vector<BallSet> sets{*testing::sample_balls("1crn.pdb", 0.8)};
  for (int round = 0; round < 10; ++round) {
    // Few places and radii, so volumes, depths and shares tie.
    BallSet balls;
    for (int n = 0; n < 60; ++n) {
      testing::add_ball(balls, 4 * testing::random_int(random, 0, 5),
                        4 * testing::random_int(random, 0, 5),
                        4 * testing::random_int(random, 0, 5), 2);
    }
    sets.push_back(balls);
  }
  std::size_t cavities = 0;
  for (const BallSet& balls : sets) {
    const auto plain = numbers_by_place(balls, 0);
    cavities += plain.size();
    for (int turn = 0; turn < 2; ++turn) {
      std::vector<BallIndex> order(balls.size());
      std::iota(order.begin(), order.end(), 0u);
      if (turn == 0) std::reverse(order.begin(), order.end());
      if (turn == 1) std::shuffle(order.begin(), order.end(), random);
      EXPECT_EQ(numbers_by_place(testing::permuted(balls, order), 0), plain);
    }
  }
  EXPECT_GT(cavities, 25u);
}

}  // namespace
}  // namespace alphascope
