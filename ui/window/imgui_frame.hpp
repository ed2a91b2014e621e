// ImGui in a host: its context, fonts, style and the drawing of one frame after another. What is in
// the frame is the caller's business.
#pragma once

#include <array>
#include <map>
#include <string>

#include "ui/widgets/style.hpp"
#include "ui/window/host.hpp"

struct ImGuiContext;

namespace alphascope {

// Input that replaces the host's while a script drives the window. Positions in pixels.
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
  explicit ImGuiFrame(Host& host, Theme theme);
  ~ImGuiFrame();
  ImGuiFrame(const ImGuiFrame&) = delete;
  ImGuiFrame& operator=(const ImGuiFrame&) = delete;

  // Follows changes of theme and display scale; then ImGui's NewFrame. `scripted` null: the host's
  // input. Returns false while the window is minimised: then draw nothing.
  bool begin(Theme theme, ScriptedInput* scripted);
  // Draws what was described since begin() and shows it.
  void end();
  // Waits until what was drawn is there.
  void finish();
  // Forgets what was described since begin(): what is on screen stays.
  void end_undrawn();

  const PanelFonts& fonts() const { return fonts_; }
  float scale() const { return scale_; }
  // Frames are work of the processor.
  bool in_software() const { return in_software_; }
  // Framebuffer that holds the last frame until the next begin(); valid before the swap only for a
  // real window, so pictures are taken through `before_swap` of end().
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
  ImGuiContext* context_;
  PanelFonts fonts_;
  Theme theme_;
  float scale_ = 0;
  unsigned framebuffer_ = 0;
  bool in_software_ = false;
};

}  // namespace alphascope
