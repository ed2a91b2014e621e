// SPDX-License-Identifier: GPL-3.0-or-later
// Runs ImGui's frames. ImGui's OpenGL backend loads OpenGL's functions by itself.
#include "ui/window/imgui_frame.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <iterator>
#include <utility>

#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/stage_timer.hpp"
#include "ui/calls.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

// In ImGui's order, from ImGuiKey_Tab on.
constexpr int kKeys[] = {key::kTab,         key::kLeft,      key::kRight, key::kUp,    key::kDown,
                         key::kPageUp,      key::kPageDown,  key::kHome,  key::kEnd,   key::kInsert,
                         key::kDelete,      key::kBackspace, key::kSpace, key::kEnter, key::kEscape,
                         key::kKeypadEnter, key::kA,         key::kC,     key::kV,     key::kX,
                         key::kY,           key::kZ};
static_assert(std::size(kKeys) == ImGuiKey_COUNT && ImGuiKey_Tab == 0);

}  // namespace

ImGuiFrame::ImGuiFrame(Host& host, Theme theme, BuiltFonts built)
    : host_(host), built_(std::move(built)), theme_(theme) {
  IMGUI_CHECKVERSION();
  context_ = ImGui::CreateContext(built_.atlas.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout of panels is fixed
  io.LogFilename = nullptr;
  std::copy(std::begin(kKeys), std::end(kKeys), io.KeyMap);
  io.KeyMap[ImGuiKey_Tab] = -1;  // key_focus.hpp handles Tab, for buttons too
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  in_software_ = draws_in_software();
  host_.start_imgui();
  ImGui_ImplOpenGL3_Init("#version 150");
  load(theme, host_.size().scale);
}

ImGuiFrame::~ImGuiFrame() {
  ImGui_ImplOpenGL3_Shutdown();
  host_.stop_imgui();
  ImGui::DestroyContext(context_);
}

void ImGuiFrame::load(Theme theme, float scale) {
  apply_style(theme, scale);
  theme_ = theme;
  if (scale == scale_) return;
  const bool first = scale_ == 0;
  scale_ = scale;
  ImGuiIO& io = ImGui::GetIO();
  const ImGuiIO defaults;
  io.MouseDoubleClickMaxDist = defaults.MouseDoubleClickMaxDist * scale;
  io.MouseDragThreshold = defaults.MouseDragThreshold * scale;
  const bool are_built = built_.scale == scale;
  fonts_ = are_built ? built_.fonts : load_fonts(scale);
  built_.scale = 0;   // the next scale builds the atlas anew
  if (first) return;  // the first frame makes the texture with ImGui's other objects
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

bool ImGuiFrame::begin(Theme theme, ScriptedInput* scripted) {
  const HostSize size = host_.size();
  if (size.width < 64 || size.height < 64) return false;
  if (theme != theme_ || size.scale != scale_) load(theme, size.scale);
  ImGui_ImplOpenGL3_NewFrame();
  if (scripted != nullptr) {
    // feed_imgui() would overwrite the mouse of the script.
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = 1.0f / 60;
    apply_scripted(*scripted);
  } else {
    host_.feed_imgui();
  }
  prepare_list_keys();
  ImGui::NewFrame();
  return true;
}

void ImGuiFrame::apply_scripted(ScriptedInput& input) const {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {input.x, input.y};
  for (int b = 0; b < 3; ++b) io.MouseDown[b] = input.down[static_cast<std::size_t>(b)];
  io.MouseWheel = input.wheel;
  input.wheel = 0;
  io.KeyCtrl = input.control;
  io.KeyShift = input.shift;
  for (const auto& [code, down] : input.keys) io.KeysDown[code] = down;
  if (!input.text.empty()) io.AddInputCharactersUTF8(input.text.c_str());
  input.text.clear();
}

void ImGuiFrame::draw() {
  ImGui::Render();
  const HostSize size = host_.size();
  framebuffer_ = host_.bind_framebuffer();
  glViewport(0, 0, size.width, size.height);
  const Colour& c = palette(theme_).panel;
  glClearColor(c.r, c.g, c.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void ImGuiFrame::finish() {
  glFinish();
}

void ImGuiFrame::end_undrawn() {
  ImGui::EndFrame();
}

void ImGuiFrame::end() {
  if (shots_only_) return end_undrawn();
  draw();
  host_.swap();
}

}  // namespace alphascope
