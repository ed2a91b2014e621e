// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the sandbox between frames. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/chart/flat_drawing.hpp"

namespace alphascope {

struct Answer;

enum class FlatPart : std::uint8_t { none, centre, rim, paper };

struct SandboxState {
  std::filesystem::path edit_when_open;  // preset that is being opened for editing; empty: none
  bool drawing = true;         // the flat drawing replaces the picture, if the balls lie in a plane
  FlatContent content;         // options of the drawing; `chosen` is set in each frame
  double snap_angstrom = 0.1;  // the mouse sets positions and radii to multiples of this
  double next_radius_angstrom = 1.5;  // radius of the next ball that is added

  // The paper: the point in its middle, and its scale. At 0 pixels the scale is chosen so that all
  // of it fits.
  FlatPoint middle{};
  double pixels_per_angstrom = 0;
  // The thing that the mouse holds, or is over.
  FlatPart held = FlatPart::none, hovered = FlatPart::none;
  std::size_t ball = 0;
  FlatPoint grip{};  // Å, from the mouse to the thing that it holds

  // The drawing, and the data from which it was made.
  std::vector<FlatShape> shapes;
  std::shared_ptr<const Answer> shapes_of;
  FlatBox shapes_box;
  FlatContent shapes_content;
};

}  // namespace alphascope
