// SPDX-License-Identifier: GPL-3.0-or-later
// The reasons why an atom of the molecule is no ball.
#pragma once

#include <cstdint>

namespace alphascope {

// The reason why an atom is no ball.
enum class DropReason : std::uint8_t {
  chain,
  selection,
  dummy,
  water,
  ion,
  ligand,
  polymer,
  hydrogen,
  altloc,
  zero_radius,
  without_radius
};

}  // namespace alphascope
