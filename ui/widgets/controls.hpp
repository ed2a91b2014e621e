// What the user can set: plain data that the panels change and the program reads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/document/commands/number_input.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope {

// For what counts alpha up and down: stops at the bounds.
inline void set_alpha(Request& request, const Alpha& angstrom2) {
  request.alpha_angstrom2 = std::clamp(angstrom2, Alpha(kAlphaRule.least), Alpha(kAlphaRule.most));
}

}  // namespace alphascope
