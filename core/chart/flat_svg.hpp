// SPDX-License-Identifier: GPL-3.0-or-later
// A flat drawing as SVG 1.1, and the colours of its shapes there and in the window.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/chart/flat_drawing.hpp"

namespace alphascope {

struct FlatColour {
  std::uint8_t r = 0, g = 0, b = 0;
  double opacity = 0;  // 0: none
};

struct FlatStyle {
  FlatColour fill, line;
  double line_width = 1;  // pixels
  bool dashed = false;
  double dot_radius = 0;  // pixels; radius of centres
};

// The style on white or dark background.
FlatStyle flat_style(FlatKind kind, bool dark = false);

struct FlatPage {
  FlatBox box;  // region that the page shows
  double width_pixels = 1000;
  std::vector<std::string> caption = {};  // lines below the drawing
  // Provenance as metadata: names and values.
  std::vector<std::pair<std::string, std::string>> origin = {};
};

// A complete document on white.
std::string flat_svg(const std::vector<FlatShape>& shapes, const FlatPage& page);

}  // namespace alphascope
