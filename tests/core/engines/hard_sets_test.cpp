// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every engine on degenerate and random sets of balls against the definition in rationals.
#include <gtest/gtest.h>

#include "tests/support/engines.hpp"
#include "tests/support/reference/oracle_check.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::EngineFactory;
using testing::NamedBalls;
using testing::OracleCounts;
using testing::Random;
using testing::RationalOracle;

void expect_equals_oracle(const EngineFactory& factory, Random& random, const NamedBalls& set,
                          std::size_t most_alphas, OracleCounts& counts) {
  const RationalOracle oracle(set.balls);
  const auto engine = factory.make(std::make_shared<const BallSet>(set.balls));
  const std::vector<double> alphas =
      testing::some_of(random, testing::interesting_alphas(oracle, set.balls.lattice), most_alphas);
  ASSERT_EQ(testing::difference_from_oracle(*engine, set, oracle, alphas, counts), "");
}

class HardSets : public testing::EngineSuite {};
INSTANTIATE_TEST_SUITE_P(Engines, HardSets, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

void expect_small_sets_equal(const EngineFactory& factory, int seed, int rounds, int most_balls) {
  Random random(static_cast<std::uint64_t>(seed));
  OracleCounts counts;
  for (int round = 0; round < rounds; ++round) {
    for (const NamedBalls& set : testing::small_hard_sets(random, most_balls)) {
      expect_equals_oracle(factory, random, set, 20, counts);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  ::testing::Test::RecordProperty("simplices_compared", std::to_string(counts.simplices));
  EXPECT_GT(counts.simplices, 5000u * static_cast<unsigned>(rounds));  // the sets are not trivial
}

TEST_P(HardSets, EqualTheDefinition) {
  expect_small_sets_equal(GetParam(), 1, testing::unless_sanitized(6, 1), 9);
}

TEST_P(HardSets, EqualTheDefinitionLong) {
  expect_small_sets_equal(GetParam(), 2, 60, 13);
}

// Two small balls barely touch at the rim of a large one, where coordinates are large beside them.
// Only integers can decide whether they meet.
TEST_P(HardSets, SmallBallsFarOutMeet) {
  BallSet balls;
  balls.lattice.digits = 6;
  testing::add_ball(balls, 0, 0, 0, 40000000);
  testing::add_ball(balls, 25903893, 30481935, 0, 400000);
  testing::add_ball(balls, 26508290, 29957813, 0, 400000);
  const auto engine = GetParam().make(std::make_shared<const BallSet>(balls));
  EXPECT_EQ(engine->compute({0}, {}).triangles.size(), 1u);
  Random random(1);
  OracleCounts counts;
  expect_equals_oracle(GetParam(), random, {"three balls", balls}, 100, counts);
}

TEST_P(HardSets, AtTheBoundsEqualTheDefinition) {
  Random random(17);
  OracleCounts counts;
  const int rounds = testing::unless_sanitized(4, 1);
  for (int round = 0; round < rounds; ++round) {
    for (const NamedBalls& set : testing::sets_at_the_bounds(random, 6)) {
      expect_equals_oracle(GetParam(), random, set, 25, counts);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(counts.simplices, 1250u * static_cast<unsigned>(rounds));
}

}  // namespace
}  // namespace alphascope
