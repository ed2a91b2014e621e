// SPDX-License-Identifier: GPL-3.0-or-later
// Tests steps as a derived result: its ball, its key, and its texts beside the engine's numbers.
#include "core/document/explain/steps_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/document/explain/step_names.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/engine/known_results.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/read/read_molecule.hpp"
#include "core/selection/prepare_balls.hpp"

namespace alphascope {
namespace {

namespace id = step_count;

struct Crambin {
  Crambin() {
    molecule = std::make_shared<const Molecule>(read_molecule(
        std::filesystem::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/1crn.pdb"));
    prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, {}));
    inputs.atoms = std::make_shared<const BallReferences>(molecule, prepared);
    inputs.balls = prepared->balls;
    inputs.balls_key = 1;
    inputs.alpha_angstrom2 = 1.4;
  }
  SelectedBall asked(const std::vector<Ref>& refs) const {
    Selection selection;
    selection.items = RefSet(refs);
    return selected_ball(selection, *inputs.atoms);
  }
  std::shared_ptr<const ExplainedSteps> told(const StepsRequest& asked) const {
    return std::static_pointer_cast<const ExplainedSteps>(explained_steps(asked).make(inputs, {}));
  }
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;
  Inputs inputs;
};

TEST(StepsResults, TheBallOfASelection) {
  const Crambin c;
  const AtomRef third = c.inputs.atoms->atom(3), fifth = c.inputs.atoms->atom(5);
  EXPECT_EQ(c.asked({third}).ball, BallIndex{3});
  EXPECT_EQ(c.asked({SimplexRef{third, fifth}}).ball, BallIndex{3});
  EXPECT_EQ(c.asked({AtomRef{100'000, 0}, fifth}).ball, BallIndex{5}) << "the first that is a ball";
  EXPECT_FALSE(c.asked({AtomRef{100'000, 0}}).ball);
  EXPECT_NE(c.asked({AtomRef{100'000, 0}}).why_not, "");
  EXPECT_FALSE(c.asked({}).ball);
  EXPECT_NE(c.asked({}).why_not, "");
  // The ball that was selected first.
  Selection selection;
  selection.items = RefSet({fifth});
  selection.note_order();
  selection.items = RefSet({third, fifth});
  selection.note_order();
  EXPECT_EQ(selected_ball(selection, *c.inputs.atoms).ball, BallIndex{5});
}

TEST(StepsResults, TheMiddleBall) {
  EXPECT_FALSE(middle_ball(BallSet()));
  BallSet balls;
  balls.centres = {{0, 0, 0}, {10'000, 0, 0}, {4'000, 1, 0}, {0, 9'000, 0}};
  balls.radii = {1000, 1000, 1000, 1000};
  EXPECT_EQ(middle_ball(balls), BallIndex{2});
}

TEST(StepsResults, EveryQuestionHasAKeyOfItsOwn) {
  Crambin c;
  std::set<std::uint64_t> keys;
  const auto add = [&](const StepsRequest& asked) {
    keys.insert(explained_steps(asked).key(c.inputs).number());
  };
  std::size_t questions = 0;
  for (const BallIndex ball : {0u, 1u, 200u}) {
    for (int bits = 0; bits < 8; ++bits) {
      TupleOptions options;
      options.edge_optimisation = bits & 1;
      options.alpha_optimisation = bits & 2;
      options.grid = bits & 4 ? TupleGridKind::thesis : TupleGridKind::automatic;
      for (const double alpha : {1.4, 2.0}) {
        c.inputs.alpha_angstrom2 = alpha;
        add({ball, StepsEngine::tuples, options});
        ++questions;
      }
    }
  }
  EXPECT_EQ(keys.size(), questions);
  EXPECT_FALSE(explained_steps({100'000}).key(c.inputs)) << "there is no such ball";
}

TEST(StepsResults, TellTheStepsAndHowMuchMoreWorkThereIs) {
  const Crambin c;
  const auto ball = *middle_ball(*c.inputs.balls);
  const auto usual = c.told({ball});
  const double alpha = c.inputs.balls->lattice.alpha_on_lattice(1.4).nearest();
  const BallSteps plain = tuple_steps(*c.inputs.balls, ball, alpha, {});
  ASSERT_EQ(usual->steps.steps.size(), plain.steps.size());
  ASSERT_EQ(usual->texts.size(), plain.steps.size());
  EXPECT_EQ(usual->steps.find(StepKind::filter)->count(id::kTested).all,
            plain.find(StepKind::filter)->count(id::kTested).all);
  EXPECT_EQ(usual->texts.front().title, "Grid");
  EXPECT_FALSE(usual->optimised);
  EXPECT_EQ(usual->growth, "");
  EXPECT_EQ(usual->optimised_count(plain.steps.front(), id::kCells), nullptr);

  StepsRequest asked{ball};
  asked.options.edge_optimisation = asked.options.alpha_optimisation = false;
  const auto slow = c.told(asked);
  ASSERT_TRUE(slow->optimised);
  const Step& filter = *slow->steps.find(StepKind::filter);
  const std::uint64_t tested = filter.count(id::kTested).all,
                      before = slow->optimised_count(filter, id::kTested)->all;
  EXPECT_EQ(before, plain.find(StepKind::filter)->count(id::kTested).all);
  EXPECT_GT(tested, before);
  const std::string made = std::to_string(plain.find(StepKind::tuples)->count(id::kKept).all);
  EXPECT_NE(slow->growth.find(" instead of " + made + " 4-tuples in kernel I,"), std::string::npos)
      << slow->growth;
  EXPECT_TRUE(slow->growth.ends_with(" instead of " + std::to_string(before) + " in kernel II."))
      << slow->growth;
  // Without only the alpha optimisation, kernel I has as much work as before.
  asked.options.edge_optimisation = true;
  EXPECT_EQ(c.told(asked)->growth.find("The same " + made + " 4-tuples in kernel I, " + made +
                                       " instead of "),
            0u)
      << c.told(asked)->growth;
  EXPECT_EQ(slow->optimised_count(filter, "no such count"), nullptr);
}

TEST(StepsResults, WhereTheStepsStopTheGrowthIsABound) {
  Crambin c;
  c.inputs.alpha_angstrom2 = 22;
  StepsRequest asked{*middle_ball(*c.inputs.balls)};
  asked.options.edge_optimisation = false;
  const auto told = c.told(asked);
  ASSERT_TRUE(told->steps.find(StepKind::too_many));
  EXPECT_TRUE(told->growth.starts_with("More than 1,000,000 instead of ")) << told->growth;
  EXPECT_TRUE(told->growth.ends_with(" 4-tuples in kernel I.")) << told->growth;
}

TEST(StepsResults, EveryEngineIsThereOnce) {
  std::set<StepsEngine> engines;
  for (const StepsEngineSpec& spec : steps_engines()) {
    EXPECT_TRUE(engines.insert(spec.engine).second);
    EXPECT_EQ(&spec_of(spec.engine), &spec);
    EXPECT_NE(spec.make, nullptr);
  }
  EXPECT_EQ(engines, (std::set{StepsEngine::tuples, StepsEngine::dual_edges}));
}

TEST(StepNames, CountsMarksAndBoxes) {
  EXPECT_EQ(step_count_name(id::kInCell), "balls in its cell");
  EXPECT_EQ(step_count_name("not_known_yet"), "not known yet");
  const Crambin c;
  const auto told = c.told({*middle_ball(*c.inputs.balls)});
  for (const Step& step : told->steps.steps) {
    for (const StepCount& count : step.counts) {
      EXPECT_EQ(step_count_name(count.id).find('_'), std::string::npos) << count.id;
    }
  }
  for (const StepKind kind : {StepKind::cube, StepKind::tuples, StepKind::filter}) {
    std::set<std::string> marks;
    for (const StepMark mark :
         {StepMark::chosen, StepMark::kept, StepMark::dropped, StepMark::undecided}) {
      marks.insert(step_mark_name(kind, mark));
    }
    EXPECT_EQ(marks.size(), 4u) << "the legend must tell them apart";
  }
  EXPECT_STREQ(step_mark_name(StepKind::filter, StepMark::kept), "valid");
  EXPECT_STREQ(step_mark_name(StepKind::tuples, StepMark::kept), "kept");
  EXPECT_STREQ(step_box_name(StepKind::grid, StepMark::chosen), "its cell");
  EXPECT_STRNE(step_box_name(StepKind::cube, StepMark::kept),
               step_box_name(StepKind::cube, StepMark::undecided));
}

}  // namespace
}  // namespace alphascope
