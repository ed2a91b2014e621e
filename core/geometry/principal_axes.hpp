// SPDX-License-Identifier: GPL-3.0-or-later
// The directions in which a set of points spreads most and least. The results are rounded, for
// views and defaults.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/real_point.hpp"

namespace alphascope {

struct BallSet;

using Matrix3 = std::array<std::array<double, 3>, 3>;

// Computes the eigenvectors of a symmetric matrix as columns of `vectors`; `a` becomes diagonal.
void diagonalise(Matrix3& a, Matrix3& vectors);

struct MainAxis {
  RealPoint middle_angstrom;  // mean of the centres
  RealPoint axis{0, 0, 1};    // unit vector
};
// The axis around which the centres spread equally, such as that of several equal copies around a
// pore. Without one, the direction in which they spread most. For many balls, only a sample is
// used. There must be at least one ball.
MainAxis main_axis(const BallSet& balls);

// Directions, as unit vectors, in which a pore may lead through the balls: the main axis and,
// unless the centres spread equally around it, the other two. An axis of symmetry of order 2 is one
// of these, and an axis of higher order is the main axis.
std::vector<RealPoint> pore_axes(const BallSet& balls);

}  // namespace alphascope
