// SPDX-License-Identifier: GPL-3.0-or-later
// Tests networks and their parts. Compares chambers with known openings, and slower algorithms that
// follow the definitions. Also tests changes that must not matter.
#include "core/cavity/split_networks.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <queue>
#include <set>
#include <vector>

#include "core/cavity/cavity_depth.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity/gates.hpp"
#include "core/cavity/network_parting.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/cavity_identity/network_radius.hpp"
#include "core/cavity_shape/cavity_mesh.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/triangulation/incidence.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"
#include "tests/core/cavity/chambers.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::chambers_in_a_row;
using testing::Random;

std::shared_ptr<const CavityGround> ground_of(const BallSet& set) {
  auto balls = std::make_shared<const BallSet>(set);
  auto triangulation = std::make_shared<const Triangulation>(make_triangulation(set, 1));
  return std::make_shared<const CavityGround>(
      make_cavity_ground(std::move(balls), std::move(triangulation)));
}

CavityTable table_of(const std::shared_ptr<const CavityGround>& ground, bool split,
                     double alpha = 0, double solvent = 0) {
  return make_cavity_table(ground, {alpha, solvent, OutsideRule::castp, split});
}

double centre_x(const CavityGround& ground, std::uint32_t t) {
  double sum = 0;
  for (const BallIndex v : ground.triangulation->tetrahedra[t]) sum += ground.balls->centres[v].x;
  return sum / 4;
}

// Walls are at multiples of 16 Å. No tetrahedron crosses one.
TEST(SplitNetworks, ChambersInARowPartAtTheirWalls) {
  const auto ground = ground_of(chambers_in_a_row({32, 31, 34}));
  const CavityTable whole = table_of(ground, false), split = table_of(ground, true);
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(whole.cavity(0).mouths.size(), 64u);
  EXPECT_TRUE(whole.cavity(0).is_network());
  EXPECT_TRUE(whole.found.networks.empty());
  ASSERT_EQ(split.size(), 4u);
  ASSERT_EQ(split.found.networks.size(), 1u);
  const SplitNetwork& network = split.found.networks[0];
  // The opening between the second and third chamber closes last, at 16 - 3.1².
  EXPECT_EQ(network.falls_apart_angstrom2, 6.39);
  EXPECT_EQ(network.mouths, 64u);
  EXPECT_EQ(network.parts, 4u);
  EXPECT_EQ(network.tetrahedra, whole.cavity(0).tetrahedra.size());
  std::set<int> chambers;
  for (std::size_t row = 0; row < 4; ++row) {
    const Cavity& part = split.cavity(row);
    const int chamber = static_cast<int>(centre_x(*ground, part.tetrahedra.front()) / 160);
    chambers.insert(chamber);
    for (const std::uint32_t t : part.tetrahedra) {
      EXPECT_EQ(static_cast<int>(centre_x(*ground, t) / 160), chamber);
    }
    EXPECT_TRUE(part.is_part());
    EXPECT_FALSE(part.is_void() || part.is_network());
    EXPECT_EQ(part.mouths.size(), 16u);
    EXPECT_EQ(part.passages.size(), chamber == 0 || chamber == 3 ? 1u : 2u);
    for (const Mouth& passage : part.passages) EXPECT_EQ(passage.triangles.size(), 2u);
    EXPECT_EQ(part.bodies, 1u);
  }
  EXPECT_EQ(chambers.size(), 4u);
  EXPECT_EQ(split.pockets, 4u);
  EXPECT_EQ(split.mouths, 64u);
  EXPECT_EQ(split.voids, 0u);
}

// The outer holes close first. One void is left, which is no network.
TEST(SplitNetworks, WhatClosesBeforeItPartsStaysWhole) {
  const auto ground = ground_of(chambers_in_a_row({30, 30}, 33));
  const CavityTable split = table_of(ground, true);
  ASSERT_EQ(split.size(), 1u);
  EXPECT_TRUE(split.cavity(0).is_network());
  EXPECT_FALSE(split.cavity(0).is_part());
  EXPECT_TRUE(split.found.networks.empty());
  const BallSet balls = chambers_in_a_row({30, 30}, 33);
  const NetworkEnd end = find_network_end(balls, split, 0);
  ASSERT_TRUE(end.alpha_angstrom2);
  EXPECT_EQ(*end.alpha_angstrom2, 5.11);  // 16 - 3.3²
  EXPECT_EQ(end.parts, 1u);
  EXPECT_EQ(end.radius_angstrom, 0.7);
  EXPECT_EQ(end.cavities, 1u);
}

TEST(SplitNetworks, NothingChangesWithoutANetwork) {
  for (const char* file : {"1crn.pdb", "4hhb.pdb.gz"}) {
    const auto ground = ground_of(*testing::sample_balls(file, 1.4));
    const CavityTable whole = table_of(ground, false, 0, 1.4),
                      split = table_of(ground, true, 0, 1.4);
    for (const Cavity& cavity : whole.found.cavities) ASSERT_FALSE(cavity.is_network());
    EXPECT_EQ(split.found, whole.found);
    EXPECT_EQ(split.order, whole.order);
  }
}

TEST(NetworkRadius, IsThatAtWhichTheOpeningsAreClosed) {
  const BallSet balls = chambers_in_a_row({32, 31});
  const CavityTable table = table_of(ground_of(balls), false);
  const NetworkEnd end = find_network_end(balls, table, 0);
  ASSERT_TRUE(end.alpha_angstrom2);
  EXPECT_EQ(*end.alpha_angstrom2, 6.39);
  EXPECT_EQ(end.parts, 3u);
  EXPECT_EQ(end.radius_angstrom, 0.9);  // 4 - 3.1, where the balls touch
  EXPECT_EQ(end.cavities, 3u);
  const CavityTable there = table_of(ground_of(with_solvent(balls, 0.9)), false, 0, 0.9);
  ASSERT_EQ(there.size(), 3u);
  EXPECT_EQ(end.largest_volume_sa_angstrom3, there.measure(0).volume_sa_angstrom3);
  EXPECT_LE(end.triangulations, 4);
  EXPECT_THROW(find_network_end(with_solvent(balls, 0.9), there, 0), std::invalid_argument);
}

// The search begins above the network's own solvent radius. There is no answer if the network stays
// whole up to 20 Å more.
TEST(NetworkRadius, IsAboveThatOfTheNetwork) {
  const BallSet balls = chambers_in_a_row({32, 31});
  for (const double solvent : {0.3, 0.85}) {
    const BallSet grown = with_solvent(balls, solvent);
    const CavityTable table = table_of(ground_of(grown), false, 0, solvent);
    ASSERT_TRUE(table.cavity(0).is_network()) << solvent;
    const NetworkEnd end = find_network_end(balls, table, table.order[0]);
    EXPECT_EQ(end.radius_angstrom, 0.9) << solvent;
  }
  BallSet wide;
  wide.lattice.digits = 0;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) testing::add_ball(wide, 200 * x, 200 * y, 200 * z, 101);
    }
  }
  const CavityTable table = table_of(ground_of(wide), false);
  ASSERT_EQ(table.size(), 1u);
  ASSERT_EQ(table.cavity(0).mouths.size(), 24u);
  const NetworkEnd end = find_network_end(wide, table, 0);
  EXPECT_FALSE(end.radius_angstrom) << *end.radius_angstrom;
  ASSERT_TRUE(end.alpha_angstrom2);
  EXPECT_EQ(*end.alpha_angstrom2, 9799);  // 20,000 - 101²
  EXPECT_EQ(end.parts, 8u);
}

// ---- of molecules, whose gaps are a network without a solvent radius

class NetworksOf : public ::testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    balls_ = testing::sample_balls(testing::unless_sanitized(1, 0) ? "4hhb.pdb.gz" : "1crn.pdb",
                                   GetParam());
    ground_ = ground_of(*balls_);
    whole_ = table_of(ground_, false, 0, GetParam());
    split_ = table_of(ground_, true, 0, GetParam());
  }
  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<const CavityGround> ground_;
  CavityTable whole_, split_;
};
INSTANTIATE_TEST_SUITE_P(SolventRadii, NetworksOf, ::testing::Values(0.0, 0.3, 0.6));

TEST_P(NetworksOf, PartsAreTogetherWhatTheNetworkIs) {
  if (split_.found.networks.empty()) GTEST_SKIP() << "no network";
  const auto clipped_whole = measure_all_exactly(whole_), clipped = measure_all_exactly(split_);
  for (std::uint32_t n = 0; n < split_.found.networks.size(); ++n) {
    const SplitNetwork& network = split_.found.networks[n];
    const std::uint32_t of = whole_.found.cavity_of_tetrahedron[network.deepest_sink];
    const Cavity& cavity = whole_.found.cavities[of];
    const CavityMeasures& m = whole_.measures[of];
    std::vector<std::uint32_t> tetrahedra, triangles;
    std::map<std::uint32_t, int> passage_triangles;
    CavityMeasures sum;
    double exact = 0, mouth_area = 0;
    std::size_t parts = 0, corners = 0;
    std::set<BallIndex> lining;
    bool has_deepest = false;
    for (std::size_t c = 0; c < split_.found.cavities.size(); ++c) {
      const Cavity& part = split_.found.cavities[c];
      if (part.network != n) continue;
      ++parts;
      has_deepest = has_deepest || part.deepest_sink == network.deepest_sink;
      tetrahedra.insert(tetrahedra.end(), part.tetrahedra.begin(), part.tetrahedra.end());
      for (const Mouth& mouth : part.mouths) {
        triangles.insert(triangles.end(), mouth.triangles.begin(), mouth.triangles.end());
      }
      EXPECT_FALSE(part.passages.empty());
      for (const Mouth& passage : part.passages) {
        for (const std::uint32_t f : passage.triangles) ++passage_triangles[f];
      }
      const CavityMeasures& own = split_.measures[c];
      sum.volume_sa_angstrom3 += own.volume_sa_angstrom3;
      sum.area_sa_angstrom2 += own.area_sa_angstrom2;
      sum.volume_ms_angstrom3 += own.volume_ms_angstrom3;
      sum.volume_of_tetrahedra_angstrom3 += own.volume_of_tetrahedra_angstrom3;
      exact += clipped[c].volume_sa_angstrom3;
      mouth_area += own.all_mouths().area_angstrom2;
      corners += own.corners;
      lining.insert(own.lining.begin(), own.lining.end());
      EXPECT_TRUE(std::isfinite(depth_angstrom(*ground_, part, own.lining)));
      EXPECT_TRUE(std::is_sorted(part.atoms.begin(), part.atoms.end()));
    }
    EXPECT_TRUE(has_deepest);
    EXPECT_EQ(parts, network.parts);
    EXPECT_GT(parts, 1u);
    std::sort(tetrahedra.begin(), tetrahedra.end());
    EXPECT_EQ(tetrahedra, cavity.tetrahedra);
    std::vector<std::uint32_t> expected;
    for (const Mouth& mouth : cavity.mouths) {
      expected.insert(expected.end(), mouth.triangles.begin(), mouth.triangles.end());
    }
    std::sort(triangles.begin(), triangles.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(triangles, expected);
    for (const auto& [f, sides] : passage_triangles) EXPECT_EQ(sides, 2);
    const double rounding = 1e-12 * m.volume_of_tetrahedra_angstrom3;
    EXPECT_NEAR(sum.volume_sa_angstrom3, m.volume_sa_angstrom3, rounding);
    EXPECT_NEAR(sum.area_sa_angstrom2, m.area_sa_angstrom2, rounding);
    EXPECT_NEAR(sum.volume_ms_angstrom3, m.volume_ms_angstrom3, rounding);
    EXPECT_NEAR(sum.volume_of_tetrahedra_angstrom3, m.volume_of_tetrahedra_angstrom3, rounding);
    EXPECT_NEAR(exact, clipped_whole[of].volume_sa_angstrom3, 10 * rounding);
    EXPECT_NEAR(mouth_area, m.all_mouths().area_angstrom2, 1e-9);
    EXPECT_EQ(corners, m.corners);
    for (const BallIndex v : m.lining) EXPECT_TRUE(lining.contains(v));
  }
  EXPECT_EQ(split_.found.voids, whole_.found.voids);
  EXPECT_EQ(split_.found.tunnels, whole_.found.tunnels);
  EXPECT_EQ(split_.found.components, whole_.found.components);
  EXPECT_EQ(split_.voids, whole_.voids);
  for (std::uint32_t c = 0; c < split_.found.cavities.size(); ++c) {
    for (const std::uint32_t t : split_.found.cavities[c].tetrahedra) {
      ASSERT_EQ(split_.found.cavity_of_tetrahedron[t], c);
    }
  }
}

// Tries every multiple of 0.01 below alpha, and compares the parts with the cavities there.
TEST_P(NetworksOf, PartsAreThoseOfTheLeastAlphaWithoutANetwork) {
  const Filtration filtration(ground_->balls, ground_->triangulation);
  const auto left_of = [&](const SplitNetwork& network, double alpha, bool& any_network) {
    std::vector<const Cavity*> left;
    static Cavities there;
    there = find_cavities(*ground_,
                          membership(filtration, ground_->balls->lattice.alpha_on_lattice(alpha)));
    const std::uint32_t of = whole_.found.cavity_of_tetrahedron[network.deepest_sink];
    any_network = false;
    for (const Cavity& cavity : there.cavities) {
      if (whole_.found.cavity_of_tetrahedron[cavity.tetrahedra.front()] != of) continue;
      left.push_back(&cavity);
      any_network = any_network || cavity.is_network();
    }
    return left;
  };
  for (std::uint32_t n = 0; n < split_.found.networks.size(); ++n) {
    const SplitNetwork& network = split_.found.networks[n];
    const long steps = std::lround(network.falls_apart_angstrom2.nearest() * 100);
    bool any = false;
    for (long step = 1; step < steps; step += testing::unless_sanitized(1, 20)) {
      left_of(network, static_cast<double>(step) / 100, any);
      ASSERT_TRUE(any) << "alpha " << static_cast<double>(step) / 100;
    }
    const auto left = left_of(network, network.falls_apart_angstrom2, any);
    EXPECT_FALSE(any);
    ASSERT_EQ(left.size(), network.parts);
    std::set<std::uint32_t> labels;
    for (const Cavity* cavity : left) {
      const std::uint32_t part = split_.found.cavity_of_tetrahedron[cavity->deepest_sink];
      EXPECT_EQ(split_.found.cavities[part].network, n);
      EXPECT_EQ(split_.found.cavities[part].deepest_sink, cavity->deepest_sink);
      labels.insert(part);
      for (const std::uint32_t t : cavity->tetrahedra) {
        EXPECT_EQ(split_.found.cavity_of_tetrahedron[t], part);
      }
    }
    EXPECT_EQ(labels.size(), network.parts);
  }
}

// A tetrahedron goes to the part to which the widest way leads. A way is as wide as the alpha at
// which its first triangle closes.
TEST_P(NetworksOf, TetrahedraGoToThePartWithTheWidestWay) {
  if (split_.found.networks.empty()) GTEST_SKIP() << "no network";
  const auto& tetrahedra_of = ground_->incidence.tetrahedra_of_triangle;
  const auto& labels = split_.found.cavity_of_tetrahedron;
  const std::size_t count = labels.size();
  std::vector<float> closes(ground_->incidence.triangles.size());
  for (std::uint32_t f = 0; f < closes.size(); ++f) closes[f] = gate_of(*ground_, f).closes;
  const LatticeAlpha zero = 0.0;
  const Membership in =
      membership(*ground_->balls, *ground_->triangulation, ground_->incidence, ground_->flow, zero);
  // Widths of the widest ways from the parts' own tetrahedra: within the part, or through all of
  // them.
  const auto widths = [&](bool within, float limit) {
    std::vector<float> width(count, -1e30f);
    std::priority_queue<std::pair<float, std::uint32_t>> queue;
    for (std::uint32_t t = 0; t < count; ++t) {
      if (labels[t] == Cavities::kNone || !split_.found.cavities[labels[t]].is_part()) continue;
      if (ground_->flow.alpha_values[t] > limit) {
        width[t] = 1e30f;
        queue.emplace(width[t], t);
      }
    }
    while (!queue.empty()) {
      const auto [wide, t] = queue.top();
      queue.pop();
      if (wide < width[t]) continue;
      for (const std::uint32_t f : ground_->incidence.triangles_of_tetrahedron[t]) {
        const auto [a, b] = tetrahedra_of[f];
        const std::uint32_t other = a == t ? b : a;
        if (in.triangles[f] || other == Incidence::kOutside || labels[other] == Cavities::kNone ||
            !split_.found.cavities[labels[other]].is_part() ||
            (within && labels[other] != labels[t])) {
          continue;
        }
        const float through = std::min(wide, closes[f]);
        if (through > width[other]) {
          width[other] = through;
          queue.emplace(through, other);
        }
      }
    }
    return width;
  };
  if (split_.found.networks.size() > 1) GTEST_SKIP() << "they have several alphas";
  const float limit =
      ground_->balls->lattice.alpha_on_lattice(split_.found.networks[0].falls_apart_angstrom2)
          .nearest_float();
  const std::vector<float> own = widths(true, limit), any = widths(false, limit);
  std::size_t given = 0;
  for (std::uint32_t t = 0; t < count; ++t) {
    ASSERT_EQ(own[t], any[t]) << t;
    given += any[t] > -1e30f && any[t] < 1e30f;
  }
  EXPECT_GT(given, 10u);
}

// Each part keeps its deepest sink. It is born where it parts, above the alpha of the table.
TEST_P(NetworksOf, PartsKeepTheirNamesWhenTheyPart) {
  const CavityLives lives = cavity_lives(*ground_);
  const Lattice& lattice = ground_->balls->lattice;
  for (const Cavity& part : split_.found.cavities) {
    if (!part.is_part()) continue;
    const SplitNetwork& network = split_.found.networks[part.network];
    const CavityLife& life = lives.of(part.deepest_sink);
    EXPECT_LE(lattice.square_angstrom(life.born), network.falls_apart_angstrom2 + 1e-4);
    EXPECT_GT(lattice.square_angstrom(life.gone), network.falls_apart_angstrom2 - 1e-4);
    EXPECT_EQ(life.born <= 0, part.deepest_sink == network.deepest_sink);
  }
  const CavityMatch match = match_cavities(whole_, split_);
  for (std::uint32_t c = 0; c < split_.found.cavities.size(); ++c) {
    const Cavity& cavity = split_.found.cavities[c];
    const std::uint32_t from = whole_.found.cavity_of_tetrahedron[cavity.deepest_sink];
    EXPECT_EQ(match.came_from[c], from);
    EXPECT_EQ(match.is_same(c), whole_.found.cavities[from].deepest_sink == cavity.deepest_sink);
  }
}

TEST_P(NetworksOf, AreTheSameForAnyNumberOfThreads) {
  const auto with = [&](int threads) {
    return tbb::task_arena(threads).execute(
        [&] { return table_of(ground_, true, 0, GetParam()).found; });
  };
  EXPECT_EQ(with(1), split_.found);
  EXPECT_EQ(with(3), split_.found);
}

// Parts as sets of places.
using Places = std::multiset<std::set<std::array<LatticePoint, 4>>>;
Places places_of(const BallSet& balls, double alpha) {
  const auto ground = ground_of(balls);
  const CavityTable table = table_of(ground, true, alpha);
  Places places;
  for (const Cavity& cavity : table.found.cavities) {
    std::set<std::array<LatticePoint, 4>> of;
    for (const std::uint32_t t : cavity.tetrahedra) {
      std::array<LatticePoint, 4> centres;
      for (std::size_t k = 0; k < 4; ++k) {
        centres[k] = balls.centres[ground->triangulation->tetrahedra[t][k]];
      }
      std::sort(centres.begin(), centres.end());
      of.insert(centres);
    }
    places.insert(std::move(of));
  }
  return places;
}

// On a cubic lattice many faces open at the same alpha. Ties between parts are then decided by
// positions, not by the order of the balls.
TEST(SplitNetworks, DoNotFollowTheOrderOfTheBalls) {
  Random random(911);
  std::size_t split = 0;
  const int rounds = testing::unless_sanitized(40, 8);
  for (int round = 0; round < rounds; ++round) {
    BallSet balls;
    balls.lattice.digits = 0;
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) {
        for (int z = 0; z < 4; ++z) {
          if (testing::random_int(random, 0, 9) == 0) continue;
          testing::add_ball(balls, 10 * x, 10 * y, 10 * z,
                            round % 2 == 0 ? 6 : testing::random_int(random, 5, 7));
        }
      }
    }
    std::vector<BallIndex> order(balls.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    const Places plain = places_of(balls, 0);
    ASSERT_EQ(places_of(testing::permuted(balls, order), 0), plain) << round;
    const CavityTable table = table_of(ground_of(balls), true);
    split += !table.found.networks.empty();
  }
  EXPECT_GT(split, static_cast<std::size_t>(rounds / 4));
}

}  // namespace
}  // namespace alphascope
