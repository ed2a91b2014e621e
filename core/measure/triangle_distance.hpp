// SPDX-License-Identifier: GPL-3.0-or-later
// The squared distance of the origin from a segment or a triangle, in double precision.
#pragma once

#include <algorithm>

#include "core/predicates/lifted.hpp"

namespace alphascope {

inline Vector3<double> difference(const Vector3<double>& a, const Vector3<double>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// Squared distance from the segment from a to b.
inline double square_from_segment(const Vector3<double>& a, const Vector3<double>& b) {
  const Vector3<double> along = difference(b, a);
  const double t = std::clamp(-dot(a, along) / dot(along, along), 0.0, 1.0);
  const Vector3<double> nearest{a.x + t * along.x, a.y + t * along.y, a.z + t * along.z};
  return dot(nearest, nearest);
}

// Squared distance from the triangle: from its plane if the foot is inside, else from its nearest
// side.
inline double square_from_triangle(const Vector3<double>& a, const Vector3<double>& b,
                                   const Vector3<double>& c) {
  const Vector3<double> normal = cross(difference(b, a), difference(c, a));
  const double square = dot(normal, normal);
  const bool within = square > 0 && dot(cross(a, b), normal) >= 0 &&
                      dot(cross(b, c), normal) >= 0 && dot(cross(c, a), normal) >= 0;
  if (within) {
    const double height = dot(a, normal);
    return height * height / square;
  }
  return std::min(
      {square_from_segment(a, b), square_from_segment(b, c), square_from_segment(c, a)});
}

}  // namespace alphascope
