// SPDX-License-Identifier: GPL-3.0-or-later
// The panels without a renderer. ImGui builds draw lists that nobody draws.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

#include "app/viewer/commands/commands.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "tests/ui/asked_calls.hpp"
#include "ui/panels/frame/window_layout.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope::testing {

struct Size {
  float width, height, scale;
};

class Panels {
 public:
  explicit Panels(Size size) : size_(size), context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.KeyMap[ImGuiKey_Enter] = key::kEnter;
    io.KeyMap[ImGuiKey_Space] = key::kSpace;
    io.KeyMap[ImGuiKey_LeftArrow] = key::kLeft;
    io.KeyMap[ImGuiKey_RightArrow] = key::kRight;
    io.KeyMap[ImGuiKey_UpArrow] = key::kUp;
    io.KeyMap[ImGuiKey_DownArrow] = key::kDown;
    io.KeyMap[ImGuiKey_Backspace] = key::kBackspace;
    io.KeyMap[ImGuiKey_A] = key::kA;
    io.KeyMap[ImGuiKey_Escape] = key::kEscape;
    add_program_commands(commands, state, calls_, panels);
    apply_style(Theme::dark, size.scale);
    fonts_ = load_fonts(size.scale);
    frame(3);
  }
  ~Panels() { ImGui::DestroyContext(context_); }

  void frame(int count = 1) {
    for (int i = 0; i < count; ++i) {
      ImGui::GetIO().DeltaTime = 1.0f / 60;
      window_frame();
    }
  }
  // A frame whose input and time are already set.
  void window_frame() {
    ImGui::GetIO().DisplaySize = {size_.width * size_.scale, size_.height * size_.scale};
    prepare_list_keys();
    ImGui::NewFrame();
    draw_window({state, rects, commands, store, inputs, calls_, panels}, fonts_, size_.scale);
    ImGui::Render();
  }
  void point_at(const std::string& name, float fx = 0.5f, float fy = 0.5f) {
    ASSERT_TRUE(rects.contains(name)) << name;
    const WidgetRect r = rects[name];
    ImGui::GetIO().MousePos = {r.x0 + fx * (r.x1 - r.x0), r.y0 + fy * (r.y1 - r.y0)};
    frame(2);
  }
  void press(bool down) {
    ImGui::GetIO().MouseDown[0] = down;
    frame(2);
  }
  void click(const std::string& name, float fx = 0.5f, float fy = 0.5f) {
    point_at(name, fx, fy);
    press(true);
    press(false);
  }
  void tap(int code) {
    ImGui::GetIO().KeysDown[code] = true;
    frame();
    ImGui::GetIO().KeysDown[code] = false;
    frame();
  }

  void type(const std::string& name, const std::string& text) {
    click(name);
    ImGui::GetIO().KeyCtrl = true;
    tap(key::kA);
    ImGui::GetIO().KeyCtrl = false;
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame(2);
    tap(key::kEnter);
  }

  WholeState state;
  Asked asked;
  Commands commands;
  WidgetRects rects;
  PanelSet panels;
  Store store{{}, [] { return std::uint64_t{1} << 30; }};
  Inputs inputs;

 private:
  AskedCalls noting_{asked};
  const Calls calls_ = noting_.calls();
  Size size_;
  ImGuiContext* context_;
  PanelFonts fonts_;
};

// An answer with as many balls and tetrahedra as haemoglobin, all alike, so there are numbers to
// show.
inline std::shared_ptr<const Answer> some_answer() {
  auto answer = std::make_shared<Answer>();
  auto molecule = std::make_shared<Molecule>();
  molecule->source = "/data/4hhb.pdb.gz";
  answer->molecule = molecule;
  auto balls = std::make_shared<BallSet>();
  balls->centres.resize(4558);
  balls->radii.resize(4558, 1700);
  answer->balls = balls;
  answer->complex.tetrahedra.simplices.assign(8090, {0, 1, 2, 3});
  answer->complex.hash = 0xf619dc636b8b16e6;
  return answer;
}

inline WholeState loaded_state() {
  WholeState s;
  s.molecule.loaded = true;
  s.molecule.name = "4hhb.pdb.gz";
  s.molecule.folder = "/data";
  s.molecule.title = "HAEMOGLOBIN";
  s.molecule.format = "PDB";
  s.molecule.summary = "used 4,558 of 4,779 atoms; dropped 221 waters; radii ProtOr";
  s.molecule.notes = {"a note"};
  s.molecule.balls = 4558;
  s.molecule.radii = {{"C", 1.7, 2.07}, {"N", 1.55, 1.95}};
  s.result = some_answer();
  const StageTimes ours{{{"grid", 0.1, true}, {"kernel II", 20, false}}, 20.2};
  s.ours = {{"dual-edge engine", "CPU, 2 threads", ""}, MeasuredRun{ours}, {}};
  const StageTimes cgal{{{"regular triangulation", 60, true}}, 60.5};
  s.cgal = {{"CGAL triangulation", "CPU", ""}, MeasuredRun{cgal}, {}};
  s.badge = {BadgeInfo::State::identical, "identical to CGAL: 8,090 of 8,090 tetrahedra"};
  s.samples = {{"crambin", "1CRN", "1crn.pdb"}};
  return s;
}

}  // namespace alphascope::testing
