// SPDX-License-Identifier: GPL-3.0-or-later
// Balls with exactly the same centre. All but one of them are hidden, and belong to no simplex.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Marks every ball that shares its centre with a larger one, or with an equal one of lower index.
// The result is empty if there is none. Throws Cancelled.
std::vector<bool> coincident_hidden(const BallSet& balls, const CancelToken& cancel = {});

}  // namespace alphascope
