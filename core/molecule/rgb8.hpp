// SPDX-License-Identifier: GPL-3.0-or-later
// A colour in eight bits per channel.
#pragma once

#include <cstdint>

namespace alphascope {

// sRGB.
struct Rgb8 {
  std::uint8_t r = 200, g = 200, b = 200;
  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

}  // namespace alphascope
