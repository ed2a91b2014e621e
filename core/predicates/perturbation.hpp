// SPDX-License-Identifier: GPL-3.0-or-later
// The rule for five balls of equal power at a point: the symbolic perturbation of the weights that
// CGAL's Regular_triangulation_3::side_of_oriented_power_sphere uses. The balls are ordered
// lexicographically by centre. Each ball's weight is decreased by infinitely more than those of all
// earlier balls together. O. Devillers, M. Teillaud, Perturbations for Delaunay and weighted
// Delaunay 3D triangulations, Comput. Geom. 44 (2011). Host and device.
#pragma once

#include "core/predicates/orthosphere.hpp"

namespace alphascope {

ALPHASCOPE_HOST_DEVICE inline bool lexicographically_less(const LiftedInt& a, const LiftedInt& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

// det(a, b, c) of the centres. It needs 93 bits, since |d_x| < 2^30.
ALPHASCOPE_HOST_DEVICE inline Int128 determinant(const LiftedInt& a, const LiftedInt& b,
                                                 const LiftedInt& c) {
  const auto n = cross(a, b);
  return static_cast<Int128>(n.x) * c.x + static_cast<Int128>(n.y) * c.y +
         static_cast<Int128>(n.z) * c.z;
}

// The sign of det(b, c, d) of centres. 64 bits suffice for most tetrahedra.
ALPHASCOPE_HOST_DEVICE inline int orientation(const LiftedInt& b, const LiftedInt& c,
                                              const LiftedInt& d) {
  constexpr std::int64_t kSmall = std::int64_t{1} << 20;
  const auto small = [](const LiftedInt& v) {
    return v.x < kSmall && v.x > -kSmall && v.y < kSmall && v.y > -kSmall && v.z < kSmall &&
           v.z > -kSmall;
  };
  if (!small(b) || !small(c) || !small(d)) return sign_of(determinant(b, c, d));
  return sign_of(dot(cross(b, c), d));  // below 3 · 2^61
}

// The change of a number, 0 before, when the weight of the ball at `centre` is decreased by an
// infinitesimal. The coefficient is exact up to a positive factor common to all terms.
struct PerturbationTerm {
  LiftedInt centre;
  Int128 coefficient;
};

// The sign of the sum of all terms: that of the first nonzero term, in falling order of the
// centres. Sorts the terms.
template <int kTerms>
ALPHASCOPE_HOST_DEVICE int sign_of_perturbation(PerturbationTerm (&terms)[kTerms]) {
  for (int a = 1; a < kTerms; ++a) {
    for (int b = a; b > 0 && lexicographically_less(terms[b - 1].centre, terms[b].centre); --b) {
      const PerturbationTerm swapped = terms[b];
      terms[b] = terms[b - 1];
      terms[b - 1] = swapped;
    }
  }
  for (const PerturbationTerm& term : terms) {
    const int sign = sign_of(term.coefficient);
    if (sign != 0) return sign;
  }
  return 0;
}

// +1 when the perturbed ball m cuts off corner ijkl, where all five powers are equal, else -1. k or
// l may be a ghost plane. A ghost has no weight, so it has no perturbation. All are lifted from
// ball i.
//
// With weights w_t - e_t, the value 2 d_m·x - c_m at the corner x changes by
//   e_l det(d_j, d_k, d_m)/D,  e_k det(d_l, d_j, d_m)/D,  e_j det(d_k, d_l, d_m)/D,  -e_m,
// with D = det(d_j, d_k, d_l), and by e_i times 1 minus the sum of those quotients of real balls.
// The first nonzero term in the order of the e decides. The term of m is never zero.
ALPHASCOPE_HOST_DEVICE inline int perturbed_cut(const LiftedInt& j, const LiftedInt& k,
                                                bool k_ghost, const LiftedInt& l, bool l_ghost,
                                                const LiftedInt& m) {
  const Int128 d = determinant(j, k, l);
  const Int128 term_j = determinant(k, l, m);
  const Int128 term_k = k_ghost ? Int128{0} : determinant(l, j, m);
  const Int128 term_l = l_ghost ? Int128{0} : determinant(j, k, m);
  // The terms are multiplied by D, so the result is multiplied by D's sign. The coefficient of a
  // ghost is 0, wherever the ghost is.
  PerturbationTerm terms[5] = {
      {{0, 0, 0, 0}, d - term_j - term_k - term_l}, {j, term_j}, {k, term_k}, {l, term_l}, {m, -d}};
  return sign_of_perturbation(terms) * sign_of(d);  // not 0: D is not 0 at a corner
}

// Is the perturbed ball m strictly inside the smallest orthosphere of triangle ijk? Only for a ball
// that touches it without the perturbation: triangle_foot_cut() is 0. All are lifted from ball i.
//
// With weights w_t - e_t, the power of m minus that of the orthosphere changes by e_m, and by -e_t
// times the barycentric coordinate of t at m's foot on the plane of ijk. The coordinates of j and k
// are (d_m × d_k)·n / n² and (d_j × d_m)·n / n² with n = d_j × d_k. Bits: 3-term sums of 61 + 61.
ALPHASCOPE_HOST_DEVICE inline bool perturbed_triangle_foot_cut(const LiftedInt& j,
                                                               const LiftedInt& k,
                                                               const LiftedInt& m) {
  const auto n = cross(j, k);
  const auto along_n = [&](const Vector3<std::int64_t>& v) {
    return static_cast<Int128>(v.x) * n.x + static_cast<Int128>(v.y) * n.y +
           static_cast<Int128>(v.z) * n.z;
  };
  const Int128 whole = along_n(n), term_j = along_n(cross(m, k)), term_k = along_n(cross(j, m));
  PerturbationTerm terms[4] = {
      {{0, 0, 0, 0}, whole - term_j - term_k}, {j, term_j}, {k, term_k}, {m, -whole}};
  return sign_of_perturbation(terms) > 0;
}

// The position of a ball m that has the same power as i and j at the foot of edge ij:
// edge_foot_cut() is 0.
enum class EdgeTie : signed char {
  // Not on the line ij. Then ij is no edge of the perturbed triangulation, or a triangle of it has
  // the same orthosphere.
  beside,
  // On the line ij. Then all three powers are equal on the whole radical plane of i and j. Ball m
  // cuts off the edge if it lies between i and j, and does not if it lies outside. Reason: the last
  // of three collinear balls in the order is an outer one, so the middle one is never hidden.
  between,
  outside
};
ALPHASCOPE_HOST_DEVICE inline EdgeTie edge_tie(const LiftedInt& j, const LiftedInt& m) {
  const auto n = cross(j, m);
  if (n.x != 0 || n.y != 0 || n.z != 0) return EdgeTie::beside;
  const std::int64_t b = j.x != 0 ? j.x : j.y != 0 ? j.y : j.z;
  const std::int64_t a = j.x != 0 ? m.x : j.y != 0 ? m.y : m.z;
  const bool between = b > 0 ? 0 < a && a < b : b < a && a < 0;
  return between ? EdgeTie::between : EdgeTie::outside;
}

}  // namespace alphascope
