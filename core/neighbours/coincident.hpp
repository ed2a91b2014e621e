// Balls with exactly the same centre: all but one are hidden and belong to no simplex.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// Marks every ball that shares its centre with a larger one, or with an equal one of lower index.
// Empty when there is none.
std::vector<bool> coincident_hidden(const BallSet& balls);

}  // namespace alphascope
