// The orthocentre of a tetrahedron: a corner of the power diagram.
#pragma once

#include <array>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

// Lattice units. By Cramer's rule, with exact numerators: orthocentres of flat tetrahedra are where
// they should be.
RealPoint orthocentre(const BallSet& balls, const std::array<BallIndex, 4>& tetrahedron);

}  // namespace alphascope
