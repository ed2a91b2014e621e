// SPDX-License-Identifier: GPL-3.0-or-later
// From which alpha on a ball is saturated (core/explain/ball_saturation.hpp), as a sentence.
#pragma once

#include <string>

#include "core/explain/ball_saturation.hpp"

namespace alphascope {

// "Saturated from α = 5.3 Å² (round 2 of the thesis): its star is final, 24 tetrahedra."
std::string saturation_text(const BallSaturation& saturation);

}  // namespace alphascope
