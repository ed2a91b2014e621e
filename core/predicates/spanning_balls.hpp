// Which space the centres of a set of balls span: a point, a line, a plane or all of it. Exact.
#pragma once

#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

// Balls whose centres span as much as all do: the first, and each that is not in what those before
// it span. At most four.
std::vector<BallIndex> spanning_balls(const BallSet& balls, BallIndex first);

// Of the affine hull of all centres: -1 (no ball) to 3. The triangulation has it too.
int dimension_of_centres(const BallSet& balls);

}  // namespace alphascope
