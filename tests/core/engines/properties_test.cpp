// SPDX-License-Identifier: GPL-3.0-or-later
// Tests properties of K_alpha for every engine: invariance, growth with alpha, Euler's number,
// agreement with the definition. Also tests cancelling, NaN and determinism.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/complex/compare.hpp"
#include "core/dual_edge/cpu_dual_edges.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/verify/verify.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::EngineFactory;
using testing::NamedBalls;
using testing::Random;

class Properties : public testing::EngineSuite {
 protected:
  AlphaComplex complex_of(const BallSet& balls, double alpha) {
    return GetParam().make(std::make_shared<const BallSet>(balls))->compute({alpha}, {});
  }
  std::vector<NamedBalls> hard_sets(Random& random) {
    return testing::large_hard_sets(random, GetParam().balls_of_large_sets());
  }
};
INSTANTIATE_TEST_SUITE_P(Engines, Properties, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

std::vector<double> some_alphas() {
  if (testing::kAddressSanitizer) return {-2, 0.5, 2, 1000};
  return {-2, 0, 0.5, 1, 2, 5, 20, 1000};
}
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The list with each vertex v replaced by names[v], sorted again.
template <int N>
SimplexList<N> renamed(const SimplexList<N>& list, const std::vector<BallIndex>& names) {
  Simplices<N> simplices = list.simplices;
  for (auto& s : simplices) {
    for (BallIndex& v : s) v = names[v];
    std::sort(s.begin(), s.end());
  }
  std::vector<std::size_t> order(list.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return simplices[a] < simplices[b]; });
  SimplexList<N> result;
  for (const std::size_t n : order) {
    result.simplices.push_back(simplices[n]);
    result.alpha_values.push_back(list.alpha_values[n]);
    result.classes.push_back(list.classes[n]);
  }
  return result;
}

AlphaComplex renamed(const AlphaComplex& complex, const std::vector<BallIndex>& names) {
  AlphaComplex result;
  result.vertices = renamed(complex.vertices, names);
  result.edges = renamed(complex.edges, names);
  result.triangles = renamed(complex.triangles, names);
  result.tetrahedra = renamed(complex.tetrahedra, names);
  return result;
}

// Balls with equal centres and radii differ only by their order.
bool has_twins(const BallSet& balls) {
  std::vector<std::pair<LatticePoint, int>> all;
  for (BallIndex i = 0; i < balls.size(); ++i) all.emplace_back(balls.centres[i], balls.radii[i]);
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

TEST_P(Properties, OrderOfTheBallsDoesNotMatter) {
  Random random(5);
  std::size_t compared = 0;
  for (const NamedBalls& set : hard_sets(random)) {
    if (has_twins(set.balls)) continue;
    ++compared;
    std::vector<BallIndex> order(set.balls.size());
    std::iota(order.begin(), order.end(), BallIndex{0});
    std::shuffle(order.begin(), order.end(), random);
    for (const double alpha : {0.0, 2.0, 20.0}) {
      const AlphaComplex plain = complex_of(set.balls, alpha);
      const AlphaComplex shuffled = complex_of(testing::permuted(set.balls, order), alpha);
      EXPECT_TRUE(compare(renamed(shuffled, order), plain).identical())
          << set.name << ", alpha " << alpha;
    }
  }
  EXPECT_GE(compared, 8u);
}

// Without ties a symmetry of the lattice maps K_alpha to that of the mapped balls.
TEST_P(Properties, SymmetriesOfTheLatticeDoNotMatter) {
  Random random(6);
  const BallSet balls = testing::random_balls(random, 250, 1000, 100, 200);
  const AlphaComplex plain = complex_of(balls, 30000);
  ASSERT_GT(plain.tetrahedra.size(), 50u);
  int axes[3] = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      BallSet image = balls;
      for (LatticePoint& p : image.centres) {
        const int v[3] = {p.x, p.y, p.z};
        p = {signs & 1 ? -v[axes[0]] : v[axes[0]], signs & 2 ? -v[axes[1]] : v[axes[1]],
             signs & 4 ? -v[axes[2]] : v[axes[2]]};
      }
      EXPECT_TRUE(compare(complex_of(image, 30000), plain).identical());
    }
  } while (std::next_permutation(axes, axes + 3));
}

// Translations keep the order that breaks ties.
TEST_P(Properties, TranslationsDoNotMatter) {
  Random random(7);
  for (const NamedBalls& set : hard_sets(random)) {
    const auto far = [](const LatticePoint& p) {
      return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 800000;
    };
    if (std::any_of(set.balls.centres.begin(), set.balls.centres.end(), far)) continue;
    BallSet image = set.balls;
    for (LatticePoint& p : image.centres) p = {p.x + 536000000, p.y - 77, p.z - 536000000};
    EXPECT_TRUE(compare(complex_of(image, 3), complex_of(set.balls, 3)).identical()) << set.name;
  }
}

TEST_P(Properties, GrowsWithAlphaAndMeetsTheDefinition) {
  Random random(8);
  for (const NamedBalls& set : hard_sets(random)) {
    const auto engine = GetParam().make(std::make_shared<const BallSet>(set.balls));
    AlphaComplex smaller = engine->compute({-1e30}, {});
    EXPECT_EQ(smaller.vertices.size(), 0u);
    for (const double alpha : some_alphas()) {
      AlphaComplex complex = engine->compute({alpha}, {});
      EXPECT_TRUE(is_subcomplex(smaller, complex)) << set.name << ", alpha " << alpha;
      const Verification verification = verify(set.balls, complex);
      EXPECT_TRUE(verification.ok()) << set.name << ": " << verification.messages.at(0);
      smaller = std::move(complex);
    }
  }
}

// At alpha = infinity the complex triangulates a convex hull, which is contractible.
TEST_P(Properties, WholeTriangulationHasEulerCharacteristicOne) {
  Random random(9);
  for (const NamedBalls& set : hard_sets(random)) {
    const AlphaComplex complex = complex_of(set.balls, kInfinity);
    EXPECT_EQ(complex.euler_characteristic(), 1) << set.name;
    EXPECT_TRUE(is_subcomplex(complex_of(set.balls, 2), complex)) << set.name;
  }
}

TEST_P(Properties, RefusesNanAndTakesInfinity) {
  Random random(13);
  const auto engine = GetParam().make(
      std::make_shared<const BallSet>(testing::random_balls(random, 30, 100, 10, 20)));
  EXPECT_THROW(engine->compute({std::numeric_limits<double>::quiet_NaN()}, {}),
               std::invalid_argument);
  EXPECT_EQ(engine->compute({-kInfinity}, {}).vertices.size(), 0u);
  EXPECT_EQ(engine->compute({kInfinity}, {}).vertices.size(), 30u);
}

TEST_P(Properties, StaysUsableWhenCancelled) {
  Random random(10);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 5000, 20000, 500, 1500));
  const auto engine = GetParam().make(balls);
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(engine->compute({100000}, context), Cancelled);
  EXPECT_THROW(engine->compute({100000, true}, context), Cancelled);
  const AlphaComplex complex = engine->compute({100000}, {});
  EXPECT_GT(complex.tetrahedra.size(), 0u);
  EXPECT_TRUE(compare(complex, make_cgal_engine(balls, {1})->compute({100000}, {})).identical());
  EXPECT_GT(complex.timings.stages.size(), 0u);
}

// Balls have many neighbours, and most of these are dropped. A ball whose centre lies in the cell
// of a larger one has none left. Centres are dense, so many cases are ties.
TEST_P(Properties, LongListsEqualCgal) {
  Random random(2024);
  int compared = 0;
  for (const int large : {7, 12}) {
    const int count = std::min(400, GetParam().most_balls);
    const int extent = static_cast<int>(3 * std::cbrt(count));
    BallSet balls = testing::random_balls(random, count, extent, 4, 7);
    for (std::size_t b = 0; b < balls.size(); b += 9) balls.radii[b] = large;
    const auto shared = std::make_shared<const BallSet>(balls);
    const auto reference = testing::keeping(make_cgal_engine(shared, {1}));
    for (const double alpha : {25.0, 60.0, 150.0}) {
      // The limit concerns the tuple engines.
      if (GetParam().name.starts_with("tuples") && !GetParam().affords(balls, alpha)) continue;
      const UniformGrid grid =
          make_uniform_grid(balls, balls.lattice.alpha_on_lattice(alpha), coincident_hidden(balls));
      EXPECT_GT(sample_neighbours(grid, 400).mean, 20);
      ++compared;
      const AlphaComplex ours = GetParam().make(shared)->compute({alpha}, {}),
                         theirs = reference->compute({alpha}, {});
      EXPECT_TRUE(compare(ours, theirs).identical()) << "radius " << large << ", alpha " << alpha;
      AlphaComplex alone = GetParam().make(shared)->compute({alpha, true}, {});
      EXPECT_EQ(alone.tetrahedra.simplices, theirs.tetrahedra.simplices);
    }
  }
  EXPECT_GT(compared, 1);
}

TEST_P(Properties, DoesNotDependOnWhatIsKnown) {
  Random random(53);
  for (const NamedBalls& set : hard_sets(random)) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*balls, 1));
    const auto filtration = std::make_shared<const Filtration>(balls, *triangulation);
    const double alpha = 2 * set.alpha_unit();
    if (!GetParam().affords(*balls, alpha)) continue;
    const auto engine = GetParam().make(balls);
    for (const bool only : {false, true}) {
      const AlphaComplex alone = engine->compute({alpha, only}, {});
      for (const auto& known_filtration : {filtration, std::shared_ptr<const Filtration>()}) {
        KnownResults known{{balls, triangulation, known_filtration}, {}, {}};
        EXPECT_TRUE(compare(engine->compute({alpha, only}, known, {}), alone).identical())
            << set.name;
      }
    }
  }
}

TEST_P(Properties, MoleculeMeetsTheDefinition) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const auto engine = GetParam().make(balls);
  for (const double alpha : {0.0, 1.4, 10.0}) {
    if (!GetParam().affords(*balls, alpha)) continue;
    const Verification verification = verify(*balls, engine->compute({alpha}, {}));
    EXPECT_TRUE(verification.ok()) << verification.messages.at(0);
    EXPECT_GT(verification.checks, 1000u);
  }
}

}  // namespace
}  // namespace alphascope
