// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data on the view, which program and panels exchange: the picture, and the mouse on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/chart/colour_scale.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/clip_handle.hpp"
#include "ui/view_problem.hpp"

namespace alphascope {

struct ColourLegend;  // ui/colour_legend.hpp
struct PictureLabel;  // ui/picture_marks.hpp

struct PointerEvent {
  // A click is a release of the left or right button near the place of the press. It follows that
  // release. A double click follows the second of two quick clicks.
  enum class Kind : std::uint8_t { move, press, release, click, wheel, double_click };
  Kind kind = Kind::move;
  int x = 0, y = 0;  // pixels from the top left of the picture
  int button = 0;    // 0 left, 1 right, 2 middle
  double wheel = 0;
  bool control = false, shift = false;
};

struct ViewportInfo {
  std::uint64_t texture = 0;  // OpenGL name of the picture; 0: none yet
  double angstrom_per_pixel = 0;
  RealPoint into_view{0, 0, -1};  // unit vector from the eye
  // The box around the balls in the picture: its middle and half its side lengths, Å.
  std::array<double, 3> box_middle{}, box_half{};
  ClipHandle clip_handle;  // of the picture in `texture`
  std::vector<ColourLegend> legends;
  std::optional<ColourRange> ball_range, simplex_range;  // of colours that show quantities
  std::vector<PictureLabel> labels;                      // of the picture in `texture`
  std::size_t hidden_balls = 0;                          // hidden by the user
  // Balls and simplices fade to kFadedOpacity, so they do not hide the things that a page draws.
  bool fades_rest = false;
  std::string not_drawn;  // parts missing from the picture for lack of memory, and the remedy
  bool outdated = false;  // the picture belongs to older settings; a new one is being made
  ViewProblem problem = ViewProblem::none;
  bool has_earlier_view = false, has_later_view = false;  // to go back and forward to
  // The panels write the picture's size in pixels, and the events of the mouse on it.
  int width = 0, height = 0;
  bool covered = false;  // something hides all of the picture, so it need not be drawn
  std::vector<PointerEvent> events;
  bool hovered = false;  // the mouse is on the picture and no button is down
  int mouse_x = 0, mouse_y = 0;
  // The thing under the mouse in words: for the tooltip, and for the status bar.
  std::string under_mouse, under_mouse_line;
};

}  // namespace alphascope
