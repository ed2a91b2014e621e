// In which directions a set of points spreads most and least. Rounded: for views and defaults.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/real_point.hpp"

namespace alphascope {

using Matrix3 = std::array<std::array<double, 3>, 3>;

// Eigenvectors (columns of `vectors`) of a symmetric matrix; `a` ends up diagonal.
void diagonalise(Matrix3& a, Matrix3& vectors);

struct MainAxis {
  RealPoint middle_angstrom;  // of the centres
  RealPoint axis{0, 0, 1};    // unit vector
};
// The axis around which the centres spread alike, such as that of several equal copies around a
// pore; without one, the direction in which they spread most. Of many balls only some are looked
// at. There must be a ball.
MainAxis main_axis(const BallSet& balls);

// Directions in which a pore may lead through them, unit vectors: the main axis and, unless the
// centres spread alike around it, the other two. An axis of symmetry of order 2 is one of these,
// and one of a higher order is the main axis.
std::vector<RealPoint> pore_axes(const BallSet& balls);

}  // namespace alphascope
