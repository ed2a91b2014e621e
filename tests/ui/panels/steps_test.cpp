// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the page "Steps" in the whole window. It shows core's results for the same ball, alpha and
// options. It goes forward, back and by itself, and draws the simplices that it describes.
#include <algorithm>

#include "core/document/explain/step_names.hpp"
#include "core/document/explain/steps_results.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/panels/explain/steps_layer.hpp"

namespace alphascope::testing {
namespace {

namespace id = step_count;

class StepsTest : public ViewerTest {
 protected:
  void settle() { run("frames 3\nwait-idle\nframes 3\n"); }
  void show(const std::string& atoms) {
    run("select.atoms " + atoms + "\nsteps.open\n");
    settle();
  }
  void open_at(double alpha, const std::string& atom = "A:CYS 16:SG") {
    open_crambin();
    run("alpha.set " + std::to_string(alpha) + "\nwait-idle\n");
    show(atom);
  }
  ViewState& state() { return viewer_->state(); }
  StepsState& memory() { return state().steps; }
  const BallSteps& steps() { return memory().shown->steps; }
  bool has(const std::string& widget) { return viewer_->widgets().contains(widget); }
  std::uint64_t count(StepKind kind, std::string_view what) {
    return steps().find(kind)->count(what).all;
  }
  // Core's steps for the ball on the page.
  BallSteps from_core(double alpha, const TupleOptions& options = {}) {
    const BallSet& balls = *state().result->balls;
    return tuple_steps(balls, steps().ball, balls.lattice.alpha_on_lattice(alpha), options);
  }
  void expect_same(const BallSteps& other) {
    ASSERT_EQ(steps().steps.size(), other.steps.size());
    for (std::size_t n = 0; n < other.steps.size(); ++n) {
      const Step &a = steps().steps[n], &b = other.steps[n];
      ASSERT_EQ(a.kind, b.kind);
      ASSERT_EQ(a.counts.size(), b.counts.size());
      for (std::size_t k = 0; k < b.counts.size(); ++k) {
        EXPECT_EQ(a.counts[k].id, b.counts[k].id);
        EXPECT_EQ(a.counts[k].all, b.counts[k].all) << b.counts[k].id;
        EXPECT_EQ(a.counts[k].here, b.counts[k].here) << b.counts[k].id;
      }
    }
    EXPECT_EQ(steps().star.tetrahedra.simplices, other.star.tetrahedra.simplices);
  }
  const Layer* layer(const std::string& name) {
    for (const auto& layer : state().layers) {
      if (layer->id == name) return layer.get();
    }
    return nullptr;
  }
  bool refused(const std::string& line) {
    return viewer_->commands().run_line(line).state == Outcome::State::refused;
  }
};

TEST_F(StepsTest, ShowsWhatCoreSaysOfTheBallOnScreen) {
  open_at(1.4);
  ASSERT_TRUE(memory().shown);
  EXPECT_EQ(name_of(*state().result->molecule, Ref{state().references->atom(steps().ball)}),
            "A:CYS 16:SG");
  expect_same(from_core(1.4));
  EXPECT_TRUE(has("steps.step.1"));
  EXPECT_TRUE(has("steps.count.balls_in_grid"));
  EXPECT_TRUE(has("steps.saturation"));
  EXPECT_EQ(memory().shown->saturation.round, 3u);
  // Another alpha, another grid, another ball.
  run("alpha.set 3\nwait-idle\n");
  settle();
  expect_same(from_core(3));
  state().settings.request.tuples.grid = TupleGridKind::thesis;
  settle();
  TupleOptions hundred;
  hundred.grid = TupleGridKind::thesis;
  expect_same(from_core(3, hundred));
  EXPECT_EQ(count(StepKind::grid, id::kCells), 1'000'000u);
  const BallIndex before = steps().ball;
  show("A:THR 1:CA");
  EXPECT_NE(steps().ball, before);
  expect_same(from_core(3, hundred));
}

TEST_F(StepsTest, AVertexOfASimplexIsAskedAbout) {
  open_at(1.4, "A:THR 1:CA");
  const auto& edge = state().result->complex.edges.simplices.front();
  state().settings.selection.items = RefSet({state().references->reference(edge)});
  settle();
  EXPECT_EQ(steps().ball, edge[0]);
}

TEST_F(StepsTest, ForwardBackAndByName) {
  open_at(1.4);
  const std::size_t last = memory().last();
  ASSERT_GE(last, 8u);
  EXPECT_EQ(memory().at(), 0u);
  run("steps.next\nsteps.next\n");
  EXPECT_EQ(memory().at(), 2u);
  run("key n\nkey shift+n\nsteps.back\n");
  EXPECT_EQ(memory().at(), 1u);
  run("steps.back\nsteps.back\n");
  EXPECT_EQ(memory().at(), 0u);
  run("key end\n");
  EXPECT_EQ(memory().at(), last);
  EXPECT_EQ(steps().steps[memory().at()].kind, StepKind::result);
  run("steps.next\n");
  EXPECT_EQ(memory().at(), last);
  run("steps.show filter\nframes 2\n");
  EXPECT_EQ(steps().steps[memory().at()].kind, StepKind::filter);
  run("steps.show 2\nframes 2\n");
  EXPECT_EQ(memory().at(), 1u);
  run("steps.show nothing\nframes 2\n");
  EXPECT_EQ(memory().at(), 1u);
  EXPECT_NE(state().notice.text().find("“nothing”"), std::string::npos) << state().notice.text();
  run("click steps.step.4\nframes 2\n");
  EXPECT_EQ(memory().at(), 3u);
  // The page stays at its step when the numbers change.
  run("alpha.set 2\nwait-idle\n");
  settle();
  EXPECT_EQ(memory().at(), 3u);
  run("view.page timings\n");
  EXPECT_TRUE(refused("steps.next"));
}

TEST_F(StepsTest, CommandsBeforeTheStepsAreKnown) {
  open_crambin();
  run("alpha.set 1.4\nselect.atoms A:CYS 16:SG\nsteps.show exact\n");
  settle();
  EXPECT_EQ(steps().steps[memory().at()].kind, StepKind::exact);
}

TEST_F(StepsTest, PlaysToTheEndAndPauses) {
  open_at(1.4);
  memory().a_second = 200;
  run("steps.show result\nframes 2\nsteps.play\nframes 1\n");
  EXPECT_LT(memory().at(), memory().last()) << "from the last it begins at the first";
  for (int k = 0; k < 400 && memory().playing; ++k) run("wait-idle\nframes 1\n");
  EXPECT_FALSE(memory().playing);
  EXPECT_EQ(memory().at(), memory().last());
  memory().a_second = 0.5;
  run("steps.play\nframes 5\n");
  EXPECT_TRUE(memory().playing);
  EXPECT_EQ(memory().at(), 0u) << "a step stays for two seconds";
  run("key esc\nframes 1\n");
  EXPECT_FALSE(memory().playing);
  EXPECT_FALSE(state().settings.selection.empty()) << "it only stopped playing";
  run("steps.play\nview.page why\nframes 2\n");
  EXPECT_FALSE(memory().playing) << "another page is open";
}

TEST_F(StepsTest, WithoutOptimisationsTheWorkGrows) {
  open_at(1.4);
  const std::uint64_t tested = count(StepKind::filter, id::kTested);
  const auto star = steps().star.tetrahedra.simplices;
  const TupleOptions setting = state().settings.request.tuples;
  EXPECT_FALSE(has("steps.growth"));
  run("click steps.edge_optimisation\nsteps.alpha_optimisation off\n");
  settle();
  TupleOptions none;
  none.edge_optimisation = none.alpha_optimisation = false;
  expect_same(from_core(1.4, none));
  EXPECT_GT(count(StepKind::filter, id::kTested), tested);
  EXPECT_EQ(steps().star.tetrahedra.simplices, star) << "the answer is the same";
  ASSERT_TRUE(memory().shown->optimised);
  const Step& filter = *steps().find(StepKind::filter);
  ASSERT_NE(memory().shown->optimised_count(filter, id::kTested), nullptr);
  EXPECT_EQ(memory().shown->optimised_count(filter, id::kTested)->all, tested);
  EXPECT_TRUE(has("steps.growth"));
  EXPECT_EQ(state().settings.request.tuples, setting) << "the engine's own switches";
  run("steps.edge_optimisation on\nsteps.alpha_optimisation on\n");
  settle();
  EXPECT_FALSE(memory().shown->optimised);
  EXPECT_EQ(count(StepKind::filter, id::kTested), tested);
}

TEST_F(StepsTest, DrawsTheStep) {
  open_at(1.4);
  run("steps.look\nsteps.show cube\n");
  settle();
  ASSERT_NE(layer("steps.kept"), nullptr);
  ASSERT_NE(layer("steps.dropped"), nullptr);
  EXPECT_EQ(layer("steps.kept")->spheres.size(), count(StepKind::cube, id::kNeighbours));
  EXPECT_EQ(layer("steps.kept")->tubes.size(), 12u) << "the cube";
  EXPECT_EQ(layer("steps.undecided")->tubes.size(), 12u) << "the cells";
  ASSERT_EQ(layer("steps.chosen")->labels.size(), 1u);
  EXPECT_EQ(layer("steps.chosen")->labels[0].text, "A:CYS 16:SG");
  const Image cube = picture();
  run("steps.show tuples\n");
  settle();
  // Candidates are drawn by their edges.
  EXPECT_GT(layer("steps.dropped")->edges.size(), 0u);
  EXPECT_FALSE(layer("steps.kept")->lines.empty()) << "seen through what is dropped";
  EXPECT_TRUE(layer("steps.kept")->tetrahedra.empty());
  EXPECT_FALSE(layer("steps.kept")->tubes.empty());
  EXPECT_NE(picture().rgba, cube.rgba);
  run("steps.show result\n");
  settle();
  EXPECT_EQ(layer("steps.kept")->tetrahedra.size(), steps().star.tetrahedra.size());
  EXPECT_EQ(layer("steps.dropped")->edges.size(), 0u);
  const Image result = picture();
  run("steps.marks off\n");
  settle();
  EXPECT_EQ(layer("steps.kept"), nullptr);
  EXPECT_NE(picture().rgba, result.rgba);
  run("steps.marks on\nview.page timings\n");
  settle();
  EXPECT_EQ(layer("steps.kept"), nullptr) << "another page is open";
}

TEST_F(StepsTest, OfTheDualEdgeEngine) {
  open_at(1.4);
  EXPECT_TRUE(has("steps.engine"));
  run("steps.engine dual_edges\n");
  settle();
  ASSERT_EQ(steps().engine, StepsEngine::dual_edges);
  const BallSet& balls = *state().result->balls;
  expect_same(dual_edge_steps(balls, steps().ball, balls.lattice.alpha_on_lattice(1.4)));
  EXPECT_FALSE(has("steps.edge_optimisation")) << "it has none of the other's switches";
  run("steps.show clipping\n");
  settle();
  const Step& clipping = *steps().find(StepKind::clipping);
  ASSERT_FALSE(clipping.segments.empty());
  std::size_t tubes = 0;
  for (const char* name : {"steps.kept", "steps.undecided", "steps.chosen", "steps.dropped"}) {
    if (const Layer* const drawn = layer(name)) tubes += drawn->tubes.size();
  }
  EXPECT_GE(tubes, clipping.segments.size() + 3) << "dual edges, and circles of the grown ball";
  run("steps.engine tuples\n");
  settle();
  EXPECT_EQ(steps().engine, StepsEngine::tuples);
}

TEST_F(StepsTest, WithoutABallItSaysWhatToDo) {
  run("view.page steps\nframes 3\n");
  EXPECT_TRUE(has("steps.nothing"));
  EXPECT_FALSE(has("steps.middle")) << "there is no molecule";
  EXPECT_TRUE(refused("steps.show grid"));
  open_crambin();
  run("steps.open\nframes 3\n");
  EXPECT_TRUE(has("steps.nothing"));
  EXPECT_FALSE(memory().shown);
  run("click steps.middle\n");
  settle();
  ASSERT_TRUE(memory().shown);
  EXPECT_EQ(steps().ball, middle_ball(*state().result->balls));
  EXPECT_EQ(state().settings.selection.items.size(), 1u);
  run("select.none\nframes 3\n");
  EXPECT_TRUE(has("steps.nothing"));
}

TEST_F(StepsTest, TheLatestBallWins) {
  open_at(60);
  run("steps.edge_optimisation off\nsteps.alpha_optimisation off\nframes 4\n");  // takes long
  show("A:THR 1:CA");
  show("A:CYS 3:SG");
  EXPECT_TRUE(memory().current);
  EXPECT_EQ(name_of(*state().result->molecule, Ref{state().references->atom(steps().ball)}),
            "A:CYS 3:SG");
  EXPECT_TRUE(steps().find(StepKind::too_many));
  EXPECT_NE(memory().shown->texts.back().text.find("The steps end here"), std::string::npos);
  EXPECT_EQ(memory().shown->growth, "") << "with the optimisations it is not counted either";
  // If there are fewer steps than before, the last one is shown. When there are more again, the
  // former step returns.
  run("steps.show exact\nframes 2\nsteps.edge_optimisation on\nsteps.alpha_optimisation on\n"
      "alpha.set 1.4\nwait-idle\n");
  settle();
  EXPECT_EQ(steps().steps.size(), 11u);
}

TEST_F(StepsTest, ABallThatTakesNoPart) {
  open_at(-4);  // carbon is gone; sulphur and its neighbours may be there
  run("alpha.set -100\nwait-idle\n");
  settle();
  ASSERT_TRUE(memory().shown);
  EXPECT_EQ(steps().left_out, LeftOutReason::empty);
  EXPECT_EQ(memory().last(), 0u);
  EXPECT_NE(memory().shown->texts[0].text.find("has shrunk to nothing"), std::string::npos);
  run("steps.next\nframes 2\n");
  EXPECT_EQ(memory().at(), 0u);
}

TEST_F(StepsTest, OfASandboxAndOfAnEmptyOne) {
  run("sandbox.new square\nframes 2\nwait-idle\nframes 2\nwait-idle\nalpha.set 8\nwait-idle\n"
      "steps.middle\n");
  settle();
  ASSERT_TRUE(memory().shown);
  expect_same(from_core(8));
  EXPECT_GE(steps().star.triangles.size(), 1u);
  for (int k = 0; k < 4; ++k) run("sandbox.remove 1\nwait-idle\n");
  run("steps.open\n");
  settle();
  EXPECT_TRUE(has("steps.nothing"));
  EXPECT_TRUE(refused("steps.middle"));
  EXPECT_EQ(state().error, "");
}

}  // namespace
}  // namespace alphascope::testing
