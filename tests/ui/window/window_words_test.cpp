// SPDX-License-Identifier: GPL-3.0-or-later
// Tests texts of the window during other work: messages over the view, tooltips, the progress of
// saving. Also tests views that the program moved.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "core/document/settings/request.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/scene/picture/step_text.hpp"

namespace alphascope::testing {
namespace {

TEST(StepText, SaysHowLongTheRestTakes) {
  EXPECT_EQ(step_text("sample", 0, 16, 0), "sample 1 of 16");
  EXPECT_EQ(step_text("sample", 4, 16, 8), "sample 5 of 16, 24 s left");
  EXPECT_EQ(step_text("frame", 1, 11, 10), "frame 2 of 11, 1 min 40 s left");
}

// No tooltip covers the widget that it describes.
TEST(Tooltips, AreBesideWhatTheySpeakOf) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.frame(3);
  ImGuiIO& io = ImGui::GetIO();
  std::size_t seen = 0;
  for (const KeyState::Stop& stop : std::vector(p.state.keys.stops)) {
    const WidgetRect r = p.rects[stop.name];
    if (!stop.visible || r.y1 - r.y0 > 60) continue;
    for (const float place : {0.1f, 0.9f}) {
      io.MousePos = {r.x0 + place * (r.x1 - r.x0), (r.y0 + r.y1) / 2};
      p.frame(2);
      io.DeltaTime = 0.5f;
      p.window_frame();
      p.frame(2);
      const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
      if (tip == nullptr || !tip->Active || tip->Hidden) continue;
      ++seen;
      const ImRect at = tip->Rect();
      EXPECT_FALSE(at.Overlaps({r.x0, r.y0, r.x1, r.y1})) << stop.name;
      EXPECT_LE(at.Max.x, 1280) << stop.name;
      EXPECT_LE(at.Max.y, 800) << stop.name;
      EXPECT_GE(at.Min.y, 0) << stop.name;
    }
  }
  EXPECT_GT(seen, 30u);
}

// A field with a tooltip that refused a number shows the reason, and the tooltip does not cover it.
TEST(Tooltips, DoNotCoverTheReasonOfARefusedNumber) {
  Panels p({1280, 800, 1});
  p.state = loaded_state();
  p.state.dialogs.show_save = true;
  p.frame(4);
  const auto tooltip = [&] {
    p.point_at("save.dpi");
    ImGui::GetIO().DeltaTime = 0.5f;
    p.window_frame();
    p.frame(2);
    const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
    return tip != nullptr && tip->Active && !tip->Hidden;
  };
  EXPECT_TRUE(tooltip());
  p.type("save.dpi", "9e9");
  EXPECT_FALSE(tooltip());
  EXPECT_TRUE(p.rects.contains("save.dpi.error"));
}

// For a slider with its value behind it, the tooltip is the slider's.
TEST(Tooltips, AreTheSliders) {
  Panels p({1280, 1700, 1});
  p.state = loaded_state();
  p.state.window.closed_sections.clear();
  p.frame(3);
  ImGuiIO& io = ImGui::GetIO();
  for (const char* name :
       {"look.depth_cue", "look.outlines", "look.face_lines", "look.samples", "alpha.solvent"}) {
    p.point_at(name, 0.3f);
    io.DeltaTime = 0.5f;
    p.window_frame();
    p.frame(2);
    const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
    EXPECT_TRUE(tip != nullptr && tip->Active && !tip->Hidden) << name;
  }
}

// --- the program

class WindowWords : public ViewerTest {
 protected:
  WindowWords() { open_crambin(); }
  ViewState& state() { return viewer_->state(); }
  double size_of_pixel() {
    run("wait-idle\nframes 2\n");
    return state().viewport.angstrom_per_pixel;
  }
};

TEST_F(WindowWords, AnotherFileClosesTheDialogThatAskedAboutTheLast) {
  state().dialogs.show_export = true;
  run("frames 3\n");
  viewer_->open_dropped({fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz"});
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(state().molecule.name, "4hhb.pdb.gz");
  EXPECT_FALSE(state().dialogs.show_export);
  EXPECT_TRUE(state().dialogs.open.empty());
  EXPECT_NE(state().notice.text().find("closed"), std::string::npos) << state().notice.text();
}

TEST_F(WindowWords, AllHiddenIsNotOutOfView) {
  run("atoms.hide all\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().viewport.problem, ViewProblem::all_hidden);
  EXPECT_TRUE(viewer_->widgets().contains("view.trouble"));
  run("view.balls off\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().viewport.problem, ViewProblem::all_hidden);
  run("atoms.show_all\nview.balls on\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().viewport.problem, ViewProblem::none);
  // All atoms are hidden but one far away, which is out of view.
  run("select.atoms A:1:CA\nkey z\nwait-idle\natoms.only A:46:CA\nwait-idle\nframes 2\n");
  EXPECT_EQ(state().viewport.problem, ViewProblem::nothing_in_view);
}

TEST_F(WindowWords, UndoBringsBackTheViewThatTheProgramMoved) {
  const double before = size_of_pixel();
  // Pages select and zoom in one step.
  state().settings.selection.items = RefSet({Ref{AtomRef{0, 0}}});
  viewer_->calls().view.zoom_to_selection();
  const double near = size_of_pixel();
  ASSERT_LT(near, 0.8 * before);
  run("edit.undo\n");
  EXPECT_DOUBLE_EQ(size_of_pixel(), before);
  EXPECT_TRUE(state().settings.selection.items.empty());
  run("edit.redo\n");
  EXPECT_NEAR(size_of_pixel(), near, 0.01 * near);  // the view may be a pixel higher
  // A view that the user has moved since stays.
  run("move view\nwheel 3\nwait-idle\n");
  const double by_hand = size_of_pixel();
  ASSERT_NE(by_hand, near);
  run("edit.undo\n");
  EXPECT_DOUBLE_EQ(size_of_pixel(), by_hand);
}

TEST_F(WindowWords, UndoBringsBackTheViewOfOtherAtoms) {
  run("select.atoms A:1:CA\nkey z\n");
  const double before = size_of_pixel();
  state().settings.open.balls.selection = "resi 46 and name CA";
  const double fitted = size_of_pixel();
  ASSERT_GT(std::fabs(fitted - before), 0.02 * before) << "the view showed none of them";
  run("edit.undo\n");
  EXPECT_NEAR(size_of_pixel(), before, 0.01 * before);  // the view may be a pixel higher
}

TEST_F(WindowWords, ASavedPictureSaysItsSamples) {
  state().settings.display.samples = 4;
  run("wait-idle\nfile.save_picture " + (folder_ / "p.png").string() + " 900 700\n");
  ScriptedInput none;
  std::string said;
  while (viewer_->busy()) {
    viewer_->step(&none);
    if (const RunningJob* job = file_job(state().jobs)) said += job->step + "\n";
  }
  EXPECT_NE(said.find(" of 4, "), std::string::npos) << said;
  EXPECT_NE(said.find(" s left"), std::string::npos) << said;
}

// An engine that is only made when the test allows it.
class SlowEngine : public ViewerTest {
 protected:
  SlowEngine() {
    ViewerOptions options;
    options.compare = false;
    options.draw_shots_only = true;
    options.preset = "fast";
    options.samples = 1;
    Session::Services services = Session::program_services();
    services.make_engine = [this, make = services.make_engine](auto&&... arguments) {
      while (held_) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return make(arguments...);
    };
    viewer_.reset();
    viewer_ = std::make_unique<Viewer>(*host_, options, services);
    open_crambin();
  }
  ~SlowEngine() override {
    held_ = false;
    viewer_.reset();
  }
  void wait(double seconds) {
    ScriptedInput none;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < end) viewer_->step(&none);
  }
  std::atomic<bool> held_ = false;
};

TEST_F(SlowEngine, ACancelledComputationIsToldUntilThePictureFollows) {
  ViewState& s = viewer_->state();
  s.notice = "Undone: solvent radius";
  held_ = true;
  s.settings.request.solvent_radius_angstrom = 1.4;  // needs another engine
  wait(0.3);
  EXPECT_EQ(s.computing_cancelled, "") << "it is still being computed";
  run("key esc\nframes 2\n");
  held_ = false;
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(s.computing_cancelled,
            "Computing was cancelled. The picture is still of alpha 0 Å² and solvent radius 0 Å.");
  EXPECT_TRUE(viewer_->widgets().contains("status.notice"));
  EXPECT_EQ(s.notice.text(), "") << "the change was not computed";
  EXPECT_EQ(s.settings.request.solvent_radius_angstrom, 1.4) << "the control keeps its value";
  EXPECT_EQ(s.result->request.solvent_radius_angstrom, 0);
  EXPECT_EQ(s.tasks.messages.front().text, s.computing_cancelled);
  s.settings.request.solvent_radius_angstrom = 0;
  run("wait-idle\nframes 3\n");
  EXPECT_EQ(s.computing_cancelled, "") << "picture and controls agree again";
  run("solvent.set 1.4\nwait-idle\nframes 3\n");
  EXPECT_EQ(s.computing_cancelled, "");
  EXPECT_EQ(s.result->request.solvent_radius_angstrom, 1.4);
}

TEST_F(SlowEngine, BallsThatWaitForTheirFirstComplexAreNoPictureOfAnother) {
  ViewState& s = viewer_->state();
  held_ = true;
  set_alpha(s.settings.request, 3);
  s.settings.request.solvent_radius_angstrom = 1.4;  // needs another engine
  wait(0.8);
  EXPECT_TRUE(s.viewport.outdated) << "that is the complex of before";
  held_ = false;
  run("wait-idle\n");
  held_ = true;
  viewer_->open(fs::path(ALPHASCOPE_SOURCE_DIR) / "resources/molecules/4hhb.pdb.gz");
  wait(2.5);
  ASSERT_EQ(s.molecule.name, "4hhb.pdb.gz");
  ASSERT_FALSE(s.result);
  EXPECT_FALSE(s.viewport.outdated);
  EXPECT_EQ(viewer_->commands().find("steps.middle")->reason_against(),
            "The complex of this molecule is not ready yet.");
  held_ = false;
  run("wait-idle\n");
  EXPECT_TRUE(s.result);
}

TEST_F(WindowWords, NoCommandSaysSuchAsTwice) {
  const auto times = [](const std::string& text) {
    int count = 0;
    for (std::size_t at = text.find("such as"); at != text.npos;
         at = text.find("such as", at + 1)) {
      ++count;
    }
    return count;
  };
  for (const CommandSpec& spec : viewer_->commands().all()) {
    EXPECT_LE(times(spec.help), 1) << spec.id;
    for (const Parameter& p : spec.parameters) {
      EXPECT_LE(times(p.what_to_type()), 1) << spec.id << ": " << p.what_to_type();
      EXPECT_LE(times(p.help), 1) << spec.id;
    }
    for (const char* words : {"", " nonsense", " nonsense nonsense"}) {
      if (spec.id.starts_with("file.") || spec.id.starts_with("lesson.")) continue;
      const Commands::Reading reading =
          Commands::read(spec, Commands::parse_words(spec, words).words);
      EXPECT_LE(times(reading.error), 1) << reading.error;
    }
  }
}

}  // namespace
}  // namespace alphascope::testing
