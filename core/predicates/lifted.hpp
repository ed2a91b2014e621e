// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a simplex relative to its first one, ball i. Every other ball k has a lifted vector
//   d = p_k - p_i,   c = |d|² + w_i - w_k.
// The bisector of i and k is { x : 2 d·x = c } with x measured from p_i. Ball k has less power
// distance than i where 2 d·x > c. The lattice bounds (lattice.hpp) give |d_x| < 2^30 and |c| <
// 2^62. Host and device.
#pragma once

#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

template <class T>
struct LiftedVector {
  T x, y, z, c;
};
using LiftedInt = LiftedVector<std::int64_t>;

template <class T>
ALPHASCOPE_HOST_DEVICE LiftedVector<T> lifted_as(const LiftedInt& v) {
  return {T(v.x), T(v.y), T(v.z), T(v.c)};
}
template <>
ALPHASCOPE_HOST_DEVICE inline LiftedVector<double> lifted_as<double>(const LiftedInt& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z),
          static_cast<double>(v.c)};
}

template <class T>
struct Vector3 {
  T x, y, z;
};
template <class A, class B>
ALPHASCOPE_HOST_DEVICE auto cross(const A& a, const B& b) {
  return Vector3<decltype(a.x * b.x)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                      a.x * b.y - a.y * b.x};
}
template <class A, class B>
ALPHASCOPE_HOST_DEVICE auto dot(const A& a, const B& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The lifted vector of ball k, seen from ball i. A Point is any type with x, y and z. Differences
// of coordinates fit 31 bits.
template <class Point>
ALPHASCOPE_INLINE LiftedInt lifted_vector(const Point& i, std::int32_t radius_i, const Point& k,
                                          std::int32_t radius_k) {
  const std::int64_t x = k.x - i.x, y = k.y - i.y, z = k.z - i.z;
  const std::int64_t weights = std::int64_t{radius_i - radius_k} * (radius_i + radius_k);
  return {x, y, z, x * x + y * y + z * z + weights};
}

// A simplex of N balls: the lifted vectors of all but the first, and the first one's weight.
template <int N>
struct LiftedSimplex {
  LiftedInt v[N > 1 ? N - 1 : 1];
  std::int64_t weight;  // square lattice units
};

// Brackets in double precision hold while |d_x| is below this bound. Then |d|² < 3 · 2^50, and the
// coordinates of the cross product of two d are below 2^51, so doubles hold both exactly. Weights
// are below 2^52, so |c| < 7 · 2^50, and c is exact as well.
inline constexpr std::int64_t kBracketLimit = std::int64_t{1} << 25;

ALPHASCOPE_HOST_DEVICE inline bool within_bracket_limit(const LiftedInt& v) {
  return v.x < kBracketLimit && v.x > -kBracketLimit && v.y < kBracketLimit &&
         v.y > -kBracketLimit && v.z < kBracketLimit && v.z > -kBracketLimit;
}
template <int N>
ALPHASCOPE_HOST_DEVICE bool within_bracket_limit(const LiftedSimplex<N>& s) {
  bool all = true;
  for (int n = 0; n < N - 1; ++n) all = all && within_bracket_limit(s.v[n]);
  return all;
}

}  // namespace alphascope
