// SPDX-License-Identifier: GPL-3.0-or-later
// A row of the list of atoms whose radius does not come from the set of radii.
#pragma once

#include "core/selection/prepare_balls.hpp"

namespace alphascope {

// Atoms whose radius does not come from the radii set.
struct RadiusRow {
  enum class Kind : std::uint8_t { guessed, by_hand, none };  // none: no radius, so no ball
  Kind kind = Kind::guessed;
  GuessedRadius radius;  // the radius in use
};

}  // namespace alphascope
