// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that no key, click or character is lost or reordered in slow frames. Texts that appear when
// the mouse rests appear without further events.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/acting_host.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "tests/ui/viewer_fixture.hpp"
#include "ui/window/input_queue.hpp"

namespace alphascope {
namespace {

using Kind = InputEvent::Kind;
using testing::ActingHost;

InputEvent pressed(int code) {
  return {.kind = Kind::key, .code = code, .down = true};
}
InputEvent released(int code) {
  return {.kind = Kind::key, .code = code, .down = false};
}
InputEvent button(bool down) {
  return {.kind = Kind::button, .code = 0, .down = down};
}
InputEvent typed(char character) {
  return {.kind = Kind::text, .character = static_cast<unsigned char>(character)};
}

// The panels, fed from a queue that received everything between two frames.
class QueuedPanels : public testing::Panels {
 public:
  QueuedPanels() : Panels({1280, 800, 1}) {
    state = testing::loaded_state();
    frame(3);
  }
  // Draws frames until the queue is empty, and returns their number.
  int play(const std::vector<InputEvent>& events) {
    for (const InputEvent& event : events) queue_.push(event);
    int frames = 0;
    do {
      queue_.feed(now_ += 0.5);  // a slow frame
      window_frame();
      ++frames;
    } while (queue_.waiting());
    return frames;
  }
  InputEvent at(const std::string& name, float fx = 0.5f) {
    const WidgetRect r = rects.at(name);
    return {.x = r.x0 + fx * (r.x1 - r.x0), .y = (r.y0 + r.y1) / 2};
  }

 private:
  InputQueue queue_;
  double now_ = 10;
};

TEST(InputQueue, FiveTapsBetweenTwoFramesAreFiveSteps) {
  QueuedPanels p;
  std::vector<InputEvent> taps;
  for (int i = 0; i < 5; ++i) {
    taps.push_back(pressed(key::kRight));
    taps.push_back(released(key::kRight));
  }
  p.play(taps);
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 0.5);
}

TEST(InputQueue, AKeyBeforeControlIsNoShortcutWithIt) {
  QueuedPanels p;
  const Theme before = p.state.window.theme;
  p.asked = {};
  p.play({pressed(key::kL), released(key::kL), pressed(key::kLeftControl), pressed(key::kB),
          released(key::kB), released(key::kLeftControl), pressed(key::kR), released(key::kR)});
  EXPECT_EQ(p.state.window.theme, before) << "Ctrl was pressed after L";
  EXPECT_TRUE(p.state.settings.display.balls) << "Ctrl was down with B";
  EXPECT_TRUE(p.asked.reset_view) << "Ctrl was up again";
}

TEST(InputQueue, AClickCountsWhereItWasThoughTheMouseWentOn) {
  QueuedPanels p;
  p.play({p.at("alpha.preset.3"), button(true), button(false), p.at("view")});
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3);
}

TEST(InputQueue, ASliderIsWhereItWasLetGo) {
  QueuedPanels p;
  p.play({p.at("alpha.slider", 0.3f), button(true), p.at("alpha.slider", 0.8f), button(false),
          p.at("view")});
  EXPECT_NEAR(p.state.settings.request.alpha_angstrom2, -3 + 0.8 * 13, 0.4);
}

TEST(InputQueue, CharactersAndKeysKeepTheirOrder) {
  QueuedPanels p;
  p.play({p.at("alpha.typed"), button(true), button(false), pressed(key::kLeftControl),
          pressed(key::kA), released(key::kA), released(key::kLeftControl)});
  // Types "17", Backspace, ".5", Enter in one slow frame, with every key down, key up and
  // character.
  p.play({pressed('1'), typed('1'), released('1'), pressed('7'), typed('7'), released('7'),
          pressed(key::kBackspace), released(key::kBackspace), pressed('.'), typed('.'),
          pressed('5'), typed('5'), released('.'), released('5'), pressed(key::kEnter),
          released(key::kEnter)});
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.5);
}

TEST(InputQueue, MovesAndWheelStepsOfAFrameAreOne) {
  QueuedPanels p;
  std::vector<InputEvent> moves;
  for (int i = 0; i < 100; ++i) moves.push_back({.x = 600.0f + static_cast<float>(i), .y = 300});
  for (int i = 0; i < 3; ++i) moves.push_back({.kind = Kind::wheel, .y = 1});
  EXPECT_LE(p.play(moves), 2);
  double steps = 0;
  for (const PointerEvent& e : p.state.viewport.events) steps += e.wheel;
  EXPECT_DOUBLE_EQ(steps, 3);
}

// --- the whole program, in real time

class ActingTest : public ::testing::Test {
 protected:
  ActingTest() : host_({1100, 700, 1, "test"}) {
    ViewerOptions options;
    options.compare = false;
    options.file = testing::crambin();
    viewer_ = std::make_unique<Viewer>(host_, options);
    host_.play({}, 1);
    viewer_->run();
    while (viewer_->busy() || !viewer_->state().result) {
      host_.play({}, 0.3);
      viewer_->run();
    }
  }
  void move_to(const std::string& name) {
    const WidgetRect r = viewer_->widgets().at(name);
    host_.move((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2);
  }
  static bool tooltip_shown() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
    return window != nullptr && window->Active && !window->Hidden;
  }

  ActingHost host_;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(ActingTest, ATooltipShowsWhileTheMouseRests) {
  host_.play({{0.1, [this] { move_to("alpha.water"); }}}, 1.5);
  viewer_->run();
  EXPECT_TRUE(tooltip_shown());
  EXPECT_LT(host_.frames, 20) << "waiting is no reason to draw";
}

TEST_F(ActingTest, TheAtomUnderTheMouseIsNamedWhileTheMouseRests) {
  // Somewhere in the middle there is a ball with no part of the complex in front of it.
  viewer_->state().settings.display.tetrahedra = false;
  const WidgetRect view = viewer_->widgets().at("view");
  std::vector<ActingHost::Act> acts;
  std::string named;
  bool shown = false;
  for (int i = 0; i < 4; ++i) {
    acts.push_back({0.1 + 0.8 * i, [this, view, i] {
                      host_.move((view.x0 + view.x1) / 2 + 9.0f * static_cast<float>(i),
                                 (view.y0 + view.y1) / 2);
                    }});
  }
  host_.after_frame = [&] {
    const std::string& text = viewer_->state().viewport.under_mouse;
    if (text.empty() || !tooltip_shown()) return;
    named = text;
    shown = true;
  };
  host_.play(acts, 3.5);
  viewer_->run();
  EXPECT_TRUE(shown);
  EXPECT_NE(named.find("centre"), std::string::npos) << named;
}

TEST_F(ActingTest, NothingHappensNothingIsDrawn) {
  // The first frames are not counted. Each background result takes one more.
  host_.play({{2, [this] { host_.frames = 0; }}}, 4);
  viewer_->run();
  EXPECT_LT(host_.frames, 8);
}

TEST_F(ActingTest, FastKeysArriveAtAWindowWithSlowFrames) {
  host_.frame_time = std::chrono::milliseconds(200);
  std::vector<ActingHost::Act> acts;
  for (int i = 0; i < 5; ++i) acts.push_back({0.1 + 0.02 * i, [this] { host_.tap(key::kRight); }});
  host_.play(acts, 1);
  viewer_->run();
  EXPECT_DOUBLE_EQ(viewer_->state().settings.request.alpha_angstrom2, 0.5);
}

}  // namespace
}  // namespace alphascope
