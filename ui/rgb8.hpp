// SPDX-License-Identifier: GPL-3.0-or-later
// Converts colours between Rgb8 (core) and Colour (window and pictures).
#pragma once

#include <cmath>

#include "core/molecule/rgb8.hpp"
#include "ui/theme.hpp"

namespace alphascope {

inline Rgb8 to_rgb8(const Colour& c) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x * 255)); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

inline Colour to_colour(const Rgb8& c) {
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255,
          static_cast<float>(c.b) / 255, 1};
}

}  // namespace alphascope
