// SPDX-License-Identifier: GPL-3.0-or-later
// Balls with exactly the same centre. All but one of them are hidden, and belong to no simplex.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// Marks every ball that shares its centre with a larger one, or with an equal one of lower index.
// The result is empty if there is none.
std::vector<bool> coincident_hidden(const BallSet& balls);

}  // namespace alphascope
