// SPDX-License-Identifier: GPL-3.0-or-later
// Sets alpha within its bounds, for keys, buttons and playback that raise or lower it in steps.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/document/commands/number_input.hpp"
#include "core/document/settings/display.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope {

// Sets alpha; values beyond kAlphaRule's bounds become the nearest bound.
inline void set_alpha(Request& request, const Alpha& angstrom2) {
  request.alpha_angstrom2 = std::clamp(angstrom2, Alpha(kAlphaRule.least), Alpha(kAlphaRule.most));
}

}  // namespace alphascope
