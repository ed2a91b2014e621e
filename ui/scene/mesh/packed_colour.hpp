// SPDX-License-Identifier: GPL-3.0-or-later
// A colour in 32 bits, as shaders read it from a buffer.
#pragma once

#include <cstdint>

#include "core/molecule/rgb8.hpp"

namespace alphascope {

using PackedColour = std::uint32_t;  // red in the lowest byte, then green and blue

constexpr PackedColour packed(const Rgb8& c) {
  return PackedColour{c.r} | PackedColour{c.g} << 8 | PackedColour{c.b} << 16;
}
constexpr Rgb8 unpacked(PackedColour c) {
  return {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(c >> 8),
          static_cast<std::uint8_t>(c >> 16)};
}

}  // namespace alphascope
