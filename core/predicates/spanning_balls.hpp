// SPDX-License-Identifier: GPL-3.0-or-later
// The affine space that the centres of a set of balls span: a point, a line, a plane or all of
// space. Exact.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct BallSet;

// Returns at most four balls whose centres span the same space as all centres: `first`, and each
// ball that is not in the span of those before it.
std::vector<BallIndex> spanning_balls(const BallSet& balls, BallIndex first);
// The same for some of the balls. Returns places in `some`, the first of which is 0; nothing if
// there are none.
std::vector<std::size_t> spanning_balls(const BallSet& balls, std::span<const BallIndex> some);

// Dimension of the affine hull of all centres: 0 to 3, or -1 without balls. It is also the
// dimension of the triangulation.
int dimension_of_centres(const BallSet& balls);

}  // namespace alphascope
