// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the menu of the right mouse button in the whole window: its subject, its entries, and why
// some are grey. A drag with the right button still zooms.
#include <imgui.h>

#include <algorithm>

#include "core/selection/atom_address.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

class ContextMenuTest : public ViewerTest {
 protected:
  const ViewState& state() { return viewer_->state(); }
  bool has(const std::string& widget) { return viewer_->widgets().contains(widget); }
  const std::vector<Ref>& items() { return state().settings.selection.items.items(); }
  // A place in the view, in shares of its size.
  static std::string at(double x, double y) {
    return "view " + std::to_string(x) + " " + std::to_string(y) + "\n";
  }
  // Returns `wanted` places in the view at which the item's name begins with `start`. Each is on
  // another atom or simplex.
  std::vector<std::string> places(const std::string& start, std::size_t wanted) {
    std::vector<std::string> found;
    std::string last;
    for (double y = 0.25; y < 0.8 && found.size() < wanted; y += 0.037) {
      for (double x = 0.3; x < 0.75 && found.size() < wanted; x += 0.031) {
        run("move " + at(x, y) + "frames 1\n");
        const std::string& line = state().viewport.under_mouse_line;
        if (!line.starts_with(start) || line == last) continue;
        last = line;
        found.push_back(at(x, y));
      }
    }
    EXPECT_EQ(found.size(), wanted) << start;
    found.resize(wanted);
    return found;
  }
  Ref hovered(const std::string& place) {
    run("move " + place + "frames 2\n");
    return state().hovered.value_or(AtomRef{99999, 0});
  }
  void choose(const std::string& entry) { run("click " + entry + "\nframes 2\nwait-idle\n"); }
};

TEST_F(ContextMenuTest, IsAboutTheAtomUnderTheMouse) {
  open_crambin();
  const std::string place = places("A:", 1)[0];
  const AtomRef atom = std::get<AtomRef>(hovered(place));
  const Molecule& molecule = state().references->molecule();
  run("right-click " + place);
  ASSERT_TRUE(has("context.title"));
  EXPECT_EQ(state().context.title, atom_address(molecule, atom.atom));
  EXPECT_TRUE(items().empty()) << "opening it selects nothing";
  choose("context.select");
  EXPECT_FALSE(has("context.title")) << "it closes";
  EXPECT_EQ(items(), std::vector<Ref>{atom});

  run("right-click " + place);
  choose("context.residue");
  EXPECT_GE(items().size(), 4u);
  for (const Ref& item : items()) {
    EXPECT_TRUE(same_residue_number(molecule.atoms[std::get<AtomRef>(item).atom],
                                    molecule.atoms[atom.atom]));
  }
  run("right-click " + place);
  choose("context.chain");
  EXPECT_EQ(items().size(), 327u);

  run("right-click " + place);
  choose("context.hide");
  EXPECT_EQ(state().viewport.hidden_balls, 1u);
  EXPECT_NE(hovered(place), Ref(atom));
  run("right-click " + place);
  choose("context.show_all");
  EXPECT_EQ(state().viewport.hidden_balls, 0u);

  run("right-click " + place +
      "click context.colour\nframes 2\nclick context.colour.Orange\nframes 2\n");
  ASSERT_EQ(state().settings.appearance.colours.size(), 1u);
  EXPECT_EQ(state().settings.appearance.colours[0].atoms, AtomSet({{0, atom.atom, atom.atom}}));
  run("right-click " + place +
      "click context.label\nframes 2\nclick context.label.name\nframes 2\n");
  ASSERT_EQ(state().settings.annotations.labels.size(), 1u);
  EXPECT_EQ(state().settings.annotations.labels[0].text, LabelText::name);
  run("right-click " + place);
  choose("context.copy_name");
  EXPECT_EQ(state().notice.text(), "Copied " + atom_address(molecule, atom.atom));
  EXPECT_EQ(ImGui::GetClipboardText(), atom_address(molecule, atom.atom));
  run("right-click " + place);
  choose("context.why");
  EXPECT_EQ(state().window.page, "why");
  EXPECT_EQ(items(), std::vector<Ref>{atom});
}

// Without a B factor there is nothing to write.
TEST_F(ContextMenuTest, ALabelThatWouldBeEmptyIsGrey) {
  std::ofstream(folder_ / "one.xyz") << "1\n\nC 0 0 0\n";
  run("open " + (folder_ / "one.xyz").string() + "\nwait-idle\n");
  const std::string place = at(0.5, 0.5);
  for (const auto& [label, labels] : {std::pair("b_factor", 0u), {"element", 1u}}) {
    run("right-click " + place + "click context.label\nframes 2\n");
    ASSERT_TRUE(has("context.label.b_factor"));
    run("click context.label." + std::string(label) + "\nframes 2\nkey esc\nkey esc\n");
    EXPECT_EQ(state().settings.annotations.labels.size(), labels) << label;
  }
}

TEST_F(ContextMenuTest, MeasuresFromTheSelectionAndSaysWhyNot) {
  open_crambin();
  const auto where = places("A:", 3);
  std::vector<Ref> atoms;
  for (const std::string& place : where) atoms.push_back(hovered(place));
  const auto reason = [&] { return viewer_->commands().find("pointed.measure")->reason_against(); };
  run("right-click " + where[0]);
  EXPECT_TRUE(reason().starts_with("Select an atom first")) << reason();
  choose("context.measure");
  EXPECT_TRUE(state().settings.annotations.measurements.empty()) << "it is grey";
  run("key esc\nframes 2\n");
  EXPECT_FALSE(has("context.title"));
  run("click " + where[1] + "right-click " + where[0]);
  EXPECT_EQ(reason(), "");
  choose("context.measure");
  ASSERT_EQ(state().settings.annotations.measurements.size(), 1u);
  EXPECT_EQ(Ref(state().settings.annotations.measurements[0].atoms[0]), atoms[1]);
  EXPECT_EQ(Ref(state().settings.annotations.measurements[0].atoms[1]), atoms[0]);
  run("right-click " + where[2]);
  choose("context.add");
  EXPECT_EQ(items().size(), 2u);
  run("right-click " + where[0]);
  choose("context.measure");
  ASSERT_EQ(state().settings.annotations.measurements.size(), 2u);
  EXPECT_EQ(Ref(state().settings.annotations.measurements[1].atoms[1]), atoms[2])
      << "selected second";
}

TEST_F(ContextMenuTest, IsAboutASimplexAndAboutNothing) {
  open_crambin();
  run("alpha.set 3\nview.balls off\nwait-idle\n");
  const std::string place = places("tetrahedron A:", 1)[0];
  const Ref simplex = hovered(place);
  run("right-click " + place);
  EXPECT_TRUE(state().context.title.starts_with("tetrahedron A:"));
  EXPECT_FALSE(has("context.residue"));
  choose("context.add");
  EXPECT_EQ(items(), std::vector<Ref>{simplex});
  run("right-click " + place);
  choose("context.zoom");
  run("right-click " + at(0.01, 0.02));
  EXPECT_FALSE(has("context.title"));
  choose("context.none");
  EXPECT_TRUE(items().empty());
  run("right-click " + at(0.01, 0.02));
  choose("context.save");
  EXPECT_TRUE(state().dialogs.show_save);
}

TEST_F(ContextMenuTest, TheKeyboardOpensItAndADragDoesNot) {
  open_crambin();
  const std::string place = places("A:", 1)[0];
  run("move " + place + "frames 2\nkey shift+f10\nframes 3\n");
  EXPECT_TRUE(has("context.title"));
  run("key esc\nframes 2\n");
  EXPECT_FALSE(has("context.title"));
  run("move " + place + "frames 2\nkey menu\nframes 3\n");
  EXPECT_TRUE(has("context.title"));
  // A right click elsewhere while it is open opens the menu of that place.
  run("right-click " + at(0.02, 0.9));
  EXPECT_FALSE(has("context.title"));
  EXPECT_TRUE(has("context.reset"));
  run("key esc\nframes 2\n");

  const double before = state().viewport.angstrom_per_pixel;
  ScriptedInput input;
  const WidgetRect view = viewer_->widgets().at("view");
  const auto step = [&](float y, bool down) {
    input.x = (view.x0 + view.x1) / 2;
    input.y = view.y0 + y * (view.y1 - view.y0);
    input.down[1] = down;
    for (int n = 0; n < 2; ++n) viewer_->step(&input);
  };
  step(0.5f, false);
  step(0.5f, true);
  step(0.7f, true);
  step(0.7f, false);
  EXPECT_NE(state().viewport.angstrom_per_pixel, before) << "it zooms";
  EXPECT_FALSE(has("context.reset"));
  EXPECT_FALSE(has("context.title"));
}

TEST_F(ContextMenuTest, RotationIsCentredAtTheSameSize) {
  open_crambin();
  run("view.centre A:THR 1:CA\nframes 3\nwait-idle\n");
  run("label.atoms name A:THR 1:CA\nframes 3\nwait-idle\n");
  const ViewportInfo& v = state().viewport;
  ASSERT_EQ(v.labels.size(), 1u);
  EXPECT_NEAR(v.labels[0].x, static_cast<float>(v.width) / 2, 2);
  EXPECT_NEAR(v.labels[0].y, static_cast<float>(v.height) / 2, 2);
  run("view.from x\nframes 3\nwait-idle\n");
  EXPECT_NEAR(v.labels[0].x, static_cast<float>(v.width) / 2, 2) << "it turns about the atom";
}

}  // namespace
}  // namespace alphascope::testing
