// SPDX-License-Identifier: GPL-3.0-or-later
// Tests hovering and selecting in the whole window: texts, clicks and drags, undo, and selections
// that survive changes of options.
#include <algorithm>
#include <cmath>

#include "core/document/store/inputs.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/atom_address.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class SelectionTest : public ViewerTest {
 protected:
  void frames(int count = 2) {
    for (int i = 0; i < count; ++i) viewer_->step(&input);
  }
  const ViewState& state() { return viewer_->state(); }
  const std::vector<Ref>& items() { return state().settings.selection.items.items(); }
  const std::string& line() { return state().viewport.under_mouse_line; }

  // Moves the mouse to x and y in the view, from 0 to 1.
  void move(double x, double y) {
    const WidgetRect view = viewer_->widgets().at("view");
    input.x = view.x0 + static_cast<float>(x) * (view.x1 - view.x0);
    input.y = view.y0 + static_cast<float>(y) * (view.y1 - view.y0);
    frames(3);
  }
  void press() {
    input.down[0] = true;
    frames();
  }
  void release() {
    input.down[0] = false;
    frames();
  }
  void click(bool control = false, bool shift = false) {
    input.control = control;
    input.shift = shift;
    press();
    release();
    input.control = input.shift = false;
    frames();
  }
  // Finds places with something of this kind: "A:" for atoms of crambin, "tetrahedron".
  std::vector<std::array<double, 2>> places(const std::string& start, std::size_t wanted) {
    std::vector<std::array<double, 2>> found;
    std::string last;
    for (double y = 0.2; y < 0.8; y += 0.037) {
      for (double x = 0.25; x < 0.75; x += 0.031) {
        if (found.size() == wanted) return found;
        move(x, y);
        if (line().starts_with(start) && line() != last) {
          found.push_back({x, y});
          last = line();
        }
      }
    }
    ADD_FAILURE() << "only " << found.size() << " places with " << start;
    return found;
  }
  void at(const std::array<double, 2>& place) { move(place[0], place[1]); }

  ScriptedInput input;
};

TEST_F(SelectionTest, TheStatusBarSaysWhatIsUnderTheMouse) {
  open_crambin();
  run("alpha.set 3\nsolvent.set 1.4\nwait-idle\n");
  at(places("A:", 1)[0]);
  ASSERT_TRUE(state().hovered);
  const AtomRef atom = std::get<AtomRef>(*state().hovered);
  const Molecule& molecule = *viewer_->session().state().molecule;
  EXPECT_TRUE(line().starts_with(atom_address(molecule, atom.atom) + "  ·  (")) << line();
  const auto ball = *state().references->ball(atom);
  const BallSet& balls = *state().references->prepared().balls;
  const double r = balls.lattice.angstrom(balls.radii[ball]) + 1.4;
  char grown[40];
  std::snprintf(grown, sizeof grown, "grown %.2f Å", std::sqrt(r * r + 3));
  EXPECT_NE(line().find(grown), std::string::npos) << line();
  EXPECT_TRUE(viewer_->widgets().contains("status.under_mouse"));
  EXPECT_FALSE(viewer_->widgets().contains("status.memory"));
  // Set, but not yet in the picture.
  viewer_->state().settings.request.alpha_angstrom2 = 9;
  frames(1);
  EXPECT_EQ(state().result->request.alpha_angstrom2, 3);
  EXPECT_NE(line().find(grown), std::string::npos) << line();
  run("wait-idle\n");
  move(0.01, 0.01);
  EXPECT_EQ(line(), "");
  EXPECT_FALSE(state().hovered);
  EXPECT_TRUE(viewer_->widgets().contains("status.memory"));
  EXPECT_TRUE(items().empty()) << "hovering selects nothing";
}

TEST_F(SelectionTest, ASimplexIsNamedWithItsAtomsClassAndAlphaValue) {
  open_crambin();
  run("alpha.set 3\nview.balls off\nwait-idle\n");
  at(places("tetrahedron A:", 1)[0]);
  const SimplexRef simplex = std::get<SimplexRef>(*state().hovered);
  EXPECT_EQ(simplex.size(), 4u);
  EXPECT_EQ(std::count(line().begin(), line().end(), ':'), 8) << line();
  EXPECT_NE(line().find("interior  ·  alpha value "), std::string::npos) << line();
  EXPECT_TRUE(line().ends_with(" Å²")) << line();
  // The complex on screen, as the filtration has it.
  const AlphaComplex expected = this->expected(3);
  std::array<BallIndex, 4> balls{};
  const auto found = *state().references->balls(simplex);
  std::copy(found.begin(), found.end(), balls.begin());
  const auto& list = expected.tetrahedra;
  const auto place = std::find(list.simplices.begin(), list.simplices.end(), balls);
  ASSERT_NE(place, list.simplices.end());
  const double value = expected.lattice.square_angstrom(
      list.alpha_values[static_cast<std::size_t>(place - list.simplices.begin())]);
  const std::string text = line().substr(line().find("value ") + std::string("value ").size());
  std::string number = text;
  const std::string minus = "−";
  if (number.starts_with(minus)) number = "-" + number.substr(minus.size());
  EXPECT_NEAR(std::stod(number), value, 1e-4) << line();
}

TEST_F(SelectionTest, ClickSelectsControlAddsEmptyClears) {
  open_crambin();
  const auto where = places("A:", 2);
  at(where[0]);
  const Ref first = *state().hovered;
  click();
  EXPECT_EQ(items(), std::vector<Ref>{first});
  EXPECT_EQ(state().selected_count_text, "1");
  at(where[1]);
  const Ref second = *state().hovered;
  ASSERT_NE(first, second);
  click(true);
  EXPECT_EQ(items().size(), 2u);
  click(false, true);
  EXPECT_EQ(items(), std::vector<Ref>{first}) << "taken out again";
  click();
  EXPECT_EQ(items(), std::vector<Ref>{second}) << "this one only";
  move(0.01, 0.01);
  click(true);
  EXPECT_EQ(items().size(), 1u) << "beside everything nothing is added";
  click();
  EXPECT_TRUE(items().empty());
  EXPECT_EQ(state().selected_count_text, "");
}

TEST_F(SelectionTest, ADragTurnsAndNeverSelects) {
  open_crambin();
  const auto place = places("A:", 1)[0];
  at(place);
  const Image before = picture();
  at(place);
  press();
  move(place[0] + 0.1, place[1]);
  at(place);  // back to the start: still a drag
  release();
  EXPECT_TRUE(items().empty());
  press();
  move(place[0] + 0.1, place[1]);
  release();
  EXPECT_TRUE(items().empty());
  EXPECT_GT(differing_pixels(before, picture()), 1000);
}

TEST_F(SelectionTest, UndoRedoEscapeAndAnotherFile) {
  open_crambin();
  at(places("A:", 1)[0]);
  click();
  const std::vector<Ref> one = items();
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(state().undo_text, "selection");
  run("edit.undo\n");
  EXPECT_TRUE(items().empty());
  EXPECT_EQ(state().redo_text, "selection");
  run("edit.redo\n");
  EXPECT_EQ(items(), one);
  run("key esc\n");
  EXPECT_TRUE(items().empty());
  EXPECT_FALSE(viewer_->commands().run("compute.stop").done()) << "nothing is left to stop";
  run("key ctrl+z\n");
  EXPECT_EQ(items(), one);
  const fs::path other = folder_ / "other.pdb";
  fs::copy_file(crambin(), other);
  run("open " + other.string() + "\nwait-idle\n");
  EXPECT_TRUE(items().empty());
  EXPECT_EQ(state().undo_text, "");
}

TEST_F(SelectionTest, OutlivesAtomsThatComeAndGo) {
  open_crambin();
  run("select.atoms A:THR 1:N, A:ASN 46\nframes 2\n");
  const std::vector<Ref> all = items();
  ASSERT_GT(all.size(), 5u);
  EXPECT_EQ(state().selected_missing, 0u);
  viewer_->state().settings.open.balls.selection = "resi 40-46";
  run("frames 1\nwait-idle\nframes 2\n");
  EXPECT_EQ(items(), all);
  EXPECT_EQ(state().selected_missing, 1u);
  EXPECT_EQ(state().selected_count_text, std::to_string(all.size()) + ", 1 not in the picture");
  const auto ball = state().references->ball(std::get<AtomRef>(all.back()));
  ASSERT_TRUE(ball);
  const Molecule& molecule = state().references->molecule();
  EXPECT_TRUE(atom_address(molecule, state().references->prepared().atom_of_ball[*ball])
                  .starts_with("A:ASN 46:"));
  viewer_->state().settings.open.balls.selection = "";
  run("frames 1\nwait-idle\nframes 2\n");
  EXPECT_EQ(items(), all);
  EXPECT_EQ(state().selected_missing, 0u);
}

TEST_F(SelectionTest, ASimplexIsInThePictureWhenTheComplexHasIt) {
  open_crambin();
  run("alpha.set 5\nview.balls off\nwait-idle\n");
  at(places("tetrahedron", 1)[0]);
  const Image before = picture();
  at(places("tetrahedron", 1)[0]);
  click();
  ASSERT_EQ(items().size(), 1u);
  EXPECT_EQ(state().selected_missing, 0u);
  ASSERT_EQ(state().layers.size(), 1u);
  EXPECT_EQ(state().layers[0]->edges.size(), 6u);
  EXPECT_GT(differing_pixels(before, picture()), 20);
  run("alpha.set -2\nwait-idle\nframes 2\n");
  EXPECT_EQ(items().size(), 1u);
  EXPECT_EQ(state().selected_missing, 1u);
  EXPECT_TRUE(state().layers.empty());
  run("alpha.set 5\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().selected_missing, 0u);
}

TEST_F(SelectionTest, SelectedBallsAreMarkedAlsoWhenBallsAreOff) {
  open_crambin();
  const Image before = picture();
  run("select.atoms A:\nframes 2\n");
  const Image marked = picture();
  EXPECT_GT(differing_pixels(before, marked), 2000);
  run("view.balls off\nview.tetrahedra off\n");
  const Image alone = picture();
  run("select.none\n");
  EXPECT_GT(differing_pixels(alone, picture()), 2000);
  run("view.balls on\nview.tetrahedra on\n");
  EXPECT_EQ(differing_pixels(before, picture()), 0) << "nothing of a mark is left";
}

TEST_F(SelectionTest, ZoomsToTheSelection) {
  open_crambin();
  const Image before = picture();
  EXPECT_FALSE(viewer_->commands().run("view.zoom_to_selection").done());
  const double scale = state().viewport.angstrom_per_pixel;
  run("select.atoms A:THR 1:N\nframes 2\nview.zoom_to_selection\nframes 2\nwait-idle\n");
  EXPECT_LT(state().viewport.angstrom_per_pixel, scale / 2);
  move(0.5, 0.5);
  EXPECT_TRUE(line().starts_with("A:THR 1:N ")) << "in the middle: " << line();
  run("select.none\nview.reset\nframes 2\n");
  EXPECT_LT(differing_pixels(before, picture()), 200);
}

TEST_F(SelectionTest, CommandsSayWhyTheyRefuse) {
  const auto why = [&](const std::string& text) {
    const Outcome outcome = viewer_->commands().run_line(text);
    EXPECT_EQ(outcome.state, Outcome::State::refused) << text;
    return outcome.why;
  };
  EXPECT_EQ(why("select.atoms A:"), "No molecule is open.");
  open_crambin();
  EXPECT_EQ(why("select.atoms X:"), "The molecule has no atom of this name.");
  EXPECT_NE(why("select.atoms A:,87").find("\"87\" has no colon; write CHAIN:RESIDUE:ATOM"),
            std::string::npos);
  run("molecule.polymers off\nwait-idle\n");
  EXPECT_NE(why("select.atoms A:THR 1:N").find("leaves all of them out"), std::string::npos);
  run("molecule.polymers on\nwait-idle\nselect.atoms A:THR 1:N\nframes 1\n");
  EXPECT_EQ(items().size(), 1u);
  run("select.add resi 2 and name CA\nframes 1\n");
  EXPECT_EQ(items().size(), 2u);
}

}  // namespace
}  // namespace alphascope::testing
