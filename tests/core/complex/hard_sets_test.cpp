// Every engine on degenerate and random sets of balls, against the definition in rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/complex/compare.hpp"
#include "core/complex/verify.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::EngineFactory;
using testing::NamedBalls;
using testing::Random;
using testing::RationalOracle;

// Alphas (Å² = lattice units here) at which something happens: the critical values themselves where
// they are doubles on alpha's own lattice, and the nearest alphas on both sides, which round to the
// same float once the value is above 16.
std::vector<double> interesting_alphas(const RationalOracle& oracle) {
  constexpr double kStep = 1.0 / 1048576;
  std::set<double> alphas = {-1e6, -1, 0, 1, 1e6, 1e300};
  for (const auto& [simplex, value] : oracle.alpha_values()) {
    const double near = std::round(value.get_d() / kStep) * kStep;
    alphas.insert({near - kStep, near, near + kStep});
  }
  return {alphas.begin(), alphas.end()};
}

std::string describe(const Comparison& c) {
  const auto text = [](const auto& d) {
    return std::to_string(d.missing.size()) + " missing " + std::to_string(d.extra.size()) +
           " extra; ";
  };
  return "V " + text(c.vertices) + "E " + text(c.edges) + "F " + text(c.triangles) + "T " +
         text(c.tetrahedra) + std::to_string(c.alpha_values_differing) + " values, " +
         std::to_string(c.classes_differing) + " classes differ";
}

std::string list_balls(const BallSet& balls) {
  std::string text;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    text += "\n  " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
            " " + std::to_string(balls.radii[i]);
  }
  return text;
}

// At most `most` of the alphas, always with the first and last ones, in random order: an engine may
// answer from what it has kept.
std::vector<double> some_of(Random& random, std::vector<double> alphas, std::size_t most) {
  while (alphas.size() > most) {
    alphas.erase(alphas.begin() + testing::random_int(random, 1, int(alphas.size()) - 2));
  }
  std::shuffle(alphas.begin(), alphas.end(), random);
  return alphas;
}

// Adds to `simplices` the number of simplices compared.
void expect_equals_oracle(const EngineFactory& factory, Random& random, const NamedBalls& set,
                          std::size_t most_alphas, std::size_t& simplices) {
  const RationalOracle oracle(set.balls);
  const auto balls = std::make_shared<const BallSet>(set.balls);
  const auto engine = factory.make(balls);
  for (const double alpha : some_of(random, interesting_alphas(oracle), most_alphas)) {
    const AlphaComplex expected = oracle.complex(set.balls.lattice.alpha_on_lattice(alpha));
    const AlphaComplex found = engine->compute({alpha}, {});
    const Comparison comparison = compare(found, expected);
    ASSERT_TRUE(comparison.identical())
        << set.name << ", alpha " << alpha << ": " << describe(comparison) << list_balls(set.balls);
    ASSERT_EQ(found.hash, expected.hash);
    const Verification verification = verify(set.balls, found);
    ASSERT_TRUE(verification.ok()) << set.name << ": " << verification.messages.at(0);
    const AlphaComplex only = engine->compute({alpha, true}, {});
    ASSERT_TRUE(compare(only, expected).identical()) << set.name << ", alpha " << alpha;
    ASSERT_EQ(only.hash, tetrahedra_hash(expected));
    simplices += found.vertices.size() + found.edges.size() + found.triangles.size() +
                 found.tetrahedra.size();
  }
}

class HardSets : public testing::EngineSuite {};
INSTANTIATE_TEST_SUITE_P(Engines, HardSets, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

void expect_small_sets_equal(const EngineFactory& factory, int seed, int rounds, int most_balls) {
  Random random(static_cast<std::uint64_t>(seed));
  std::size_t simplices = 0;
  for (int round = 0; round < rounds; ++round) {
    for (const NamedBalls& set : testing::small_hard_sets(random, most_balls)) {
      expect_equals_oracle(factory, random, set, 20, simplices);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  ::testing::Test::RecordProperty("simplices_compared", std::to_string(simplices));
  EXPECT_GT(simplices, 5000u * static_cast<unsigned>(rounds));  // the sets are not trivial
}

TEST_P(HardSets, EqualTheDefinition) {
  expect_small_sets_equal(GetParam(), 1, 6, 9);
}

TEST_P(HardSets, EqualTheDefinitionLong) {
  expect_small_sets_equal(GetParam(), 2, 60, 13);
}

}  // namespace
}  // namespace alphascope
