// What the sandbox remembers between frames. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/chart/flat_drawing.hpp"
#include "core/document/store/answer.hpp"

namespace alphascope {

enum class FlatPart : std::uint8_t { none, centre, rim, paper };

struct SandboxMemory {
  std::filesystem::path edit_when_open;  // a preset that is being opened; empty: none
  bool drawing = true;                // the flat drawing in place of the picture, where it can be
  FlatContent content;                // `chosen` is filled in each frame
  double snap_angstrom = 0.1;         // places and radii of the mouse are multiples of it
  double next_radius_angstrom = 1.5;  // of a ball that is added

  // The paper: what is in its middle, and how large; 0 pixels: all of it fits.
  FlatPoint middle{};
  double pixels_per_angstrom = 0;
  // What the mouse holds, or is over.
  FlatPart held = FlatPart::none, hovered = FlatPart::none;
  std::size_t ball = 0;
  FlatPoint grip{};  // Å, from the mouse to what it holds

  // What is drawn, and of what.
  std::vector<FlatShape> shapes;
  std::shared_ptr<const Answer> shapes_of;
  FlatBox shapes_box;
  FlatContent shapes_content;
};

}  // namespace alphascope
