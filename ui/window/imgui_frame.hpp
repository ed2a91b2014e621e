// SPDX-License-Identifier: GPL-3.0-or-later
// ImGui in a host: its context, fonts, style and the drawing of frames. The caller describes the
// frames' content.
#pragma once

#include <array>
#include <map>
#include <string>

#include "ui/widgets/style.hpp"
#include "ui/window/host.hpp"

struct ImGuiContext;

namespace alphascope {

// Input of a script, which replaces the host's. Positions are in pixels.
struct ScriptedInput {
  float x = -1, y = -1;
  std::array<bool, 3> down{};
  float wheel = 0;           // consumed by one frame
  std::string text;          // UTF-8, consumed by one frame
  std::map<int, bool> keys;  // codes of keys.hpp
  bool control = false, shift = false;
};

class ImGuiFrame {
 public:
  // `built`: fonts for the host's scale, made while the window opened; without them they are made
  // now.
  ImGuiFrame(Host& host, Theme theme, BuiltFonts built);
  ~ImGuiFrame();
  ImGuiFrame(const ImGuiFrame&) = delete;
  ImGuiFrame& operator=(const ImGuiFrame&) = delete;

  // Starts a frame: follows changes of theme and display scale, then calls ImGui's NewFrame. If
  // `scripted` is null, the host's input is used. Returns false while the window is minimised or
  // smaller than 64 pixels; the caller must then draw nothing.
  bool begin(Theme theme, ScriptedInput* scripted);
  // Draws the frame and shows it, unless draw_shots_only() was called.
  void end();
  // From now on end() discards frames. Those with a `before_swap` are drawn.
  void draw_shots_only() { shots_only_ = true; }
  // Waits until OpenGL has drawn everything.
  void finish();
  // Discards the frame; the screen stays as it is.
  void end_undrawn();

  const PanelFonts& fonts() const { return fonts_; }
  float scale() const { return scale_; }
  // Whether OpenGL draws the frames on the CPU.
  bool in_software() const { return in_software_; }
  // Draws the frame, calls `before_swap` with its framebuffer, and shows it. A window's framebuffer
  // is valid only before the swap, so pictures of frames are taken in `before_swap`.
  template <class Function>
  void end(Function&& before_swap) {
    draw();
    before_swap(framebuffer_);
    host_.swap();
  }

 private:
  void draw();
  void apply_scripted(ScriptedInput& input) const;
  void load(Theme theme, float scale);

  Host& host_;
  BuiltFonts built_;
  ImGuiContext* context_;
  PanelFonts fonts_;
  Theme theme_;
  float scale_ = 0;
  unsigned framebuffer_ = 0;
  bool in_software_ = false;
  bool shots_only_ = false;
};

}  // namespace alphascope
