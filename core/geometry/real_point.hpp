// SPDX-License-Identifier: GPL-3.0-or-later
// A point or a vector in double precision, for inexact results: curves, lengths, positions. Signs
// are decided on the lattice.
#pragma once

#include <cmath>

#include "core/geometry/lattice_point.hpp"

namespace alphascope {

struct RealPoint {
  double x = 0, y = 0, z = 0;

  friend RealPoint operator+(const RealPoint& a, const RealPoint& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend RealPoint operator-(const RealPoint& a, const RealPoint& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend RealPoint operator*(double factor, const RealPoint& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
  }
  friend bool operator==(const RealPoint&, const RealPoint&) = default;
};

inline RealPoint real_point(const LatticePoint& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}
// Rounds each coordinate, which must be within the lattice's bounds.
inline LatticePoint nearest_lattice_point(const RealPoint& p) {
  return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y)),
          static_cast<std::int32_t>(std::lround(p.z))};
}

inline double dot(const RealPoint& a, const RealPoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline RealPoint cross(const RealPoint& a, const RealPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const RealPoint& a) {
  return std::sqrt(dot(a, a));
}
// (0, 0, 0) for a vector without a direction.
inline RealPoint unit_vector(const RealPoint& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : RealPoint{};
}
// Two unit vectors that are normal to a unit vector and to each other.
inline void normals_of(const RealPoint& axis, RealPoint& first, RealPoint& second) {
  const RealPoint other = std::fabs(axis.x) < 0.6 ? RealPoint{1, 0, 0} : RealPoint{0, 1, 0};
  first = unit_vector(cross(axis, other));
  second = cross(axis, first);
}

}  // namespace alphascope
