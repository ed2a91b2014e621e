// SPDX-License-Identifier: GPL-3.0-or-later
// The mouse on the picture: the item under it, clicks, the context menu, and drags.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "app/viewer/mouse/ball_drag.hpp"
#include "app/viewer/mouse/hit_text.hpp"
#include "app/viewer/parts/shown_marks.hpp"
#include "ui/window/imgui_frame.hpp"

namespace alphascope {

class Pointing {
 public:
  Pointing(ViewState& state, SceneController& scene, ShownMarks& marks, const ImGuiFrame& frame)
      : state_(state), scene_(scene), marks_(marks), frame_(frame) {}

  void describe_under_mouse();
  void click(const PointerEvent& event);
  // Moves the item under the mouse to the middle of the view, which then turns about it.
  void centre_on_it(const PointerEvent& event);
  bool move_view();          // or a ball of a sandbox; returns whether the view has moved
  void open_context_menu();  // for the item under the mouse
  void place_clip_handle();

 private:
  struct UnderMouse {
    std::optional<Ref> what;  // none: a body or tube that a panel draws
    HitText text;
    std::string page = {};                   // id of the page that a click opens; empty: none
    std::optional<std::size_t> cavity = {};  // row of the cavity whose body it is
  };
  std::optional<UnderMouse> under(int x, int y) const;  // x and y in pixels of the picture
  UnderMouse under_atom(std::size_t atom) const;        // index of the atom in the molecule
  std::optional<std::size_t> sandbox_ball_at(int x, int y) const;
  // Drags a ball of a sandbox in 3-D. Returns whether the event belongs to such a drag.
  bool drag_ball(const PointerEvent& event);

  ViewState& state_;
  SceneController& scene_;
  ShownMarks& marks_;
  const ImGuiFrame& frame_;
  std::optional<BallDrag> ball_drag_;
  std::optional<std::array<double, 3>> clip_pivot_;  // set while the handle is held
};

}  // namespace alphascope
