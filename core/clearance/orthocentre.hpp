// SPDX-License-Identifier: GPL-3.0-or-later
// The orthocentre of a tetrahedron: a corner of the power diagram.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// In lattice units. Uses Cramer's rule with exact numerators, so that orthocentres of flat
// tetrahedra are accurate as well.
RealPoint orthocentre(const BallSet& balls, const std::array<BallIndex, 4>& tetrahedron);

}  // namespace alphascope
