// SPDX-License-Identifier: GPL-3.0-or-later
// Tests results made at once: in order, each once, within the available memory.
#include "core/document/store/evaluator.hpp"

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/internal_error.hpp"
#include "core/triangulation/memory_need.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/support/five_balls.hpp"

namespace alphascope {
namespace {

struct EvaluatorTest : testing::StoreTest {
  Evaluator evaluator{[this] { return budget; }};
};

TEST_F(EvaluatorTest, MakesFirstWhatAResultIsMadeOf) {
  const auto source = number("source");
  const Definition<int> sum{{.id = "sum",
                             .title = "Sum",
                             .made_of = {&source},
                             .key = key_of_balls,
                             .memory =
                                 [&](const Inputs& in) {
                                   return MemoryNeed{0, static_cast<std::uint64_t>(in.of(source))};
                                 }},
                            [&](const Inputs& in, const RunContext&) {
                              return std::make_shared<const int>(in.of(source) + 1);
                            }};
  EXPECT_EQ(*evaluator.evaluate(sum, inputs(7)), 8);
  EXPECT_EQ(made, 1);
}

TEST_F(EvaluatorTest, MakesEachOnceAKey) {
  const auto source = number("source");
  const auto first = evaluator.evaluate(source, inputs(1));
  EXPECT_EQ(evaluator.evaluate(source, inputs(1)), first);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(*evaluator.evaluate(source, inputs(2)), 2);
  EXPECT_EQ(made, 2);
  const auto follows_alpha = table("table");
  EXPECT_EQ(*evaluator.evaluate(follows_alpha, inputs(1, 0.5)), 0.5);
  EXPECT_EQ(*evaluator.evaluate(follows_alpha, inputs(1, 1.5)), 1.5);
  EXPECT_EQ(made, 4);
}

TEST_F(EvaluatorTest, MakesNothingThatDoesNotFit) {
  budget = 999'999'999;
  const auto large = number("large", 2'000'000'000);
  try {
    evaluator.evaluate(large, inputs(1));
    FAIL() << "It was made.";
  } catch (const NoRoom& error) {
    EXPECT_STREQ(error.what(),
                 "large: This result needs about 2.00 GB of memory, and 1.00 GB is available.");
  }
  EXPECT_EQ(made, 0);
  budget = 2'000'000'000;
  EXPECT_EQ(*evaluator.evaluate(large, inputs(1)), 1);
}

TEST_F(EvaluatorTest, EndsWhenItIsCancelled) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(evaluator.evaluate(number("source"), inputs(1), context), Cancelled);
  EXPECT_EQ(made, 0);
}

TEST_F(EvaluatorTest, SaysWhenTheInputsDoNotSuffice) {
  EXPECT_THROW(evaluator.evaluate(number("source"), Inputs{}), InternalError);
}

// The window always asks with the same rules, but the command line may use others.
TEST_F(EvaluatorTest, CavitiesOfOtherRulesAreOtherResults) {
  budget = 1'000'000'000;
  Inputs in;
  testing::Random random(1);
  in.balls = std::make_shared<const BallSet>(testing::five_balls(random, 0));
  in.balls_key = 1;
  in.alpha_angstrom2 = 0;
  const auto usual = evaluator.evaluate(cavity_table(), in);
  EXPECT_EQ(evaluator.evaluate(cavity_table(), in), usual);
  Inputs pocket = in;
  pocket.outside_rule = OutsideRule::pocket;
  EXPECT_EQ(evaluator.evaluate(cavity_table(), pocket)->question.rule, OutsideRule::pocket);
  EXPECT_EQ(evaluator.evaluate(cavity_table(), pocket)->ground, usual->ground);
  Inputs strict = in;
  strict.flow_ties = FlowTies::strict;
  EXPECT_NE(evaluator.evaluate(cavity_table(), strict)->ground, usual->ground);
  EXPECT_NE(evaluator.evaluate(whole_cavity_lives(), pocket),
            evaluator.evaluate(whole_cavity_lives(), in));
}

}  // namespace
}  // namespace alphascope
