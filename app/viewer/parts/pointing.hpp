// The mouse on the picture.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "app/viewer/parts/ball_drag.hpp"
#include "app/viewer/parts/hit_text.hpp"
#include "app/viewer/parts/shown_marks.hpp"
#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Pointing {
 public:
  Pointing(ViewState& state, SceneController& scene, ShownMarks& marks, const ImGuiFrame& frame)
      : state_(state), scene_(scene), marks_(marks), frame_(frame) {}

  void describe_under_mouse();
  void click(const PointerEvent& event);
  bool drag_ball(const PointerEvent& event);  // of a sandbox in space; whether it is one of that
  void open_context_menu();                   // of what is under the mouse
  void place_clip_handle();

 private:
  struct UnderMouse {
    std::optional<Ref> what;  // none: a body of a panel's, which hides what is behind it
    HitText text;
  };
  std::optional<UnderMouse> under(int x, int y) const;  // pixels of the picture
  UnderMouse under_atom(std::size_t atom) const;        // of the molecule
  std::optional<std::size_t> sandbox_ball_at(int x, int y) const;

  ViewState& state_;
  SceneController& scene_;
  ShownMarks& marks_;
  const ImGuiFrame& frame_;
  std::optional<BallDrag> ball_drag_;
  std::optional<std::array<double, 3>> clip_pivot_;  // while the handle is held
};

}  // namespace alphascope
