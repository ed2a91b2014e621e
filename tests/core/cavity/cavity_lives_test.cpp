// SPDX-License-Identifier: GPL-3.0-or-later
// Tests lives of cavities: at each of many alphas, the living cavities are those of the complex
// there.
#include "core/cavity/cavity_lives.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
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

using testing::NamedBalls;
using testing::Random;

CavityGround ground_of(const std::shared_ptr<const BallSet>& balls) {
  return make_cavity_ground(balls,
                            std::make_shared<const Triangulation>(make_triangulation(*balls, 1)));
}

struct Known {
  std::set<std::uint32_t> cavities, voids;  // cavities and voids by their deepest sinks
  friend bool operator==(const Known&, const Known&) = default;
};
Known found_at(const CavityGround& ground, const Filtration& filtration, double alpha,
               OutsideRule rule) {
  Known known;
  for (const Cavity& cavity : find_cavities(ground, membership(filtration, alpha), rule).cavities) {
    known.cavities.insert(cavity.deepest_sink);
    if (cavity.is_void()) known.voids.insert(cavity.deepest_sink);
  }
  return known;
}
Known alive_at(const CavityLives& lives, double alpha) {
  Known known;
  for (std::size_t n = 0; n < lives.sinks.size(); ++n) {
    const CavityLife& life = lives.lives[n];
    if (!(life.born <= alpha && alpha < life.gone)) continue;
    known.cavities.insert(lives.sinks[n]);
    if (life.closed <= alpha) known.voids.insert(lives.sinks[n]);
  }
  return known;
}

// Alphas lie between the alpha values of all triangles and tetrahedra of small sets, and some of
// large ones.
TEST(CavityLives, SayWhichCavitiesThereAre) {
  Random random(121);
  std::vector<NamedBalls> sets = testing::large_hard_sets(random, 200);
  for (NamedBalls& set : testing::small_hard_sets(random, 12)) sets.push_back(std::move(set));
  sets.push_back({"many", testing::random_balls(random, 500, 600, 20, 60)});
  std::size_t voids = 0, pockets = 0;
  for (const NamedBalls& set : sets) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const CavityGround ground = ground_of(balls);
    if (ground.triangulation->dimension < 3) continue;
    const Filtration filtration(balls, *ground.triangulation);
    std::vector<float> values(filtration.top().triangles.alpha_values.begin(),
                              filtration.top().triangles.alpha_values.end());
    for (const float value : filtration.top().tetrahedra.alpha_values) values.push_back(value);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const OutsideRule rule : {OutsideRule::castp, OutsideRule::pocket}) {
      const CavityLives lives = cavity_lives(ground, rule);
      for (std::size_t n = 0; n + 1 < values.size(); n += values.size() / 30 + 1) {
        // No alpha lies between two neighbouring floats.
        const double alpha = (double(values[n]) + double(values[n + 1])) / 2;
        if (float(alpha) == values[n] || float(alpha) == values[n + 1]) continue;
        const Known found = found_at(ground, filtration, alpha, rule);
        ASSERT_EQ(alive_at(lives, alpha), found) << set.name << ", alpha " << alpha;
        voids += found.voids.size();
        pockets += found.cavities.size() - found.voids.size();
      }
    }
  }
  EXPECT_GT(voids, 100u);
  EXPECT_GT(pockets, 1000u);
}

// Balls on few places have sinks with exactly equal ortho-radii.
TEST(CavityLives, DoNotFollowTheOrderOfTheBalls) {
  Random random(122);
  std::size_t sinks = 0, equal = 0;
  for (int round = 0; round < 100; ++round) {
    BallSet balls;
    for (int n = 0; n < 12; ++n) {
      testing::add_ball(balls, 2 * testing::random_int(random, 0, 2),
                        2 * testing::random_int(random, 0, 2),
                        2 * testing::random_int(random, 0, 3), testing::random_int(random, 1, 2));
    }
    using Life = std::tuple<std::vector<LatticePoint>, float, float, float>;
    // Lives in the order of the centres.
    const auto lives_of = [](const BallSet& set) {
      const CavityGround ground = ground_of(std::make_shared<const BallSet>(set));
      const CavityLives lives = cavity_lives(ground);
      std::vector<Life> all(lives.sinks.size());
      for (std::size_t n = 0; n < lives.sinks.size(); ++n) {
        std::vector<LatticePoint> centres;
        for (const BallIndex v : ground.triangulation->tetrahedra[lives.sinks[n]]) {
          centres.push_back(set.centres[v]);
        }
        std::sort(centres.begin(), centres.end());
        const CavityLife& life = lives.lives[n];
        all.at(lives.places.at(n)) = {centres, life.born, life.closed, life.gone};
      }
      return all;
    };
    std::vector<BallIndex> order(balls.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    const std::vector<Life> plain = lives_of(balls);
    EXPECT_TRUE(std::is_sorted(plain.begin(), plain.end()));
    ASSERT_EQ(lives_of(testing::permuted(balls, order)), plain) << round;
    sinks += plain.size();
    std::set<float> depths;
    for (const Life& life : plain) depths.insert(std::get<3>(life));
    equal += plain.size() - depths.size();
  }
  EXPECT_GT(sinks, 40u);
  EXPECT_GT(equal, 10u);
}

TEST(CavityLives, AreTheSameForAnyNumberOfThreads) {
  const CavityGround ground = ground_of(testing::sample_balls("4hhb.pdb.gz", 1.4));
  const auto with = [&](int threads) {
    return tbb::task_arena(threads).execute([&] { return cavity_lives(ground); });
  };
  const CavityLives alone = with(1), other = with(3);
  EXPECT_EQ(other.sinks, alone.sinks);
  EXPECT_EQ(other.lives, alone.lives);
  ASSERT_FALSE(alone.sinks.empty());
  EXPECT_EQ(alone.of(alone.sinks.back()), alone.lives.back());
  EXPECT_THROW(alone.of(0xffffffff), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
