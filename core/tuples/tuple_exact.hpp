// SPDX-License-Identifier: GPL-3.0-or-later
// Exact decisions about tuples: conflicts with ties broken, ortho-radii, alpha values. Kernel III
// uses them, and they decide every case that a filter leaves open. Host and device; the balls are
// lifted from the tuple's first one.
//
// Ties. Ball m with exactly the power rho at the orthocentre x of a simplex s may or may not
// destroy s under the perturbation of perturbation.hpp:
//  - m outside the affine hull of s: s is in the perturbed triangulation iff it is a face of a
//    larger simplex of it with orthocentre x and the same rho. (All balls of power rho at x make up
//    a cell of higher dimension, which the perturbation triangulates.) The larger simplex is tested
//    itself, and its faces are added, so s need not count.
//  - m in the hull, m = sum of lambda_v p_v: at the perturbed orthocentre the power of m exceeds
//    that of s by e_m - sum of lambda_v e_v. The last ball in lexicographic order with a nonzero
//    coefficient decides. For a 4-tuple this is perturbed_cut().
#pragma once

#include "core/predicates/perturbation.hpp"
#include "core/predicates/simplex_decisions.hpp"

namespace alphascope {

// The effect of ball m on a simplex. `defers`: the larger simplices around it decide.
enum class Conflict : signed char { none, defers, destroys };

// A tie of a ball in the hull of the simplex: the lexicographically last centre with a nonzero
// coefficient decides, as explained above.
struct HullTie {
  LiftedInt last;
  int sign;  // sign of the excess of the perturbed power
  ALPHASCOPE_INLINE void add(const LiftedInt& centre, int s) {
    if (s == 0 || lexicographically_less(centre, last)) return;
    last = centre;
    sign = s;
  }
};

// The conflict tests of one simplex; an object is made once per tuple. regular() is false when the
// balls are affinely dependent.
template <int K, class Integer>
struct ExactCentre;

// Edge ij.
template <class Integer>
struct ExactCentre<1, Integer> {
  LiftedInt j;
  ALPHASCOPE_HOST_DEVICE explicit ExactCentre(const LiftedInt (&v)[1]) : j(v[0]) {}
  ALPHASCOPE_HOST_DEVICE bool regular() const { return true; }
  ALPHASCOPE_HOST_DEVICE Conflict with(const LiftedInt& m) const {
    const int side = edge_foot_cut(j, m);
    if (side != 0) return side > 0 ? Conflict::destroys : Conflict::none;
    const EdgeTie tie = edge_tie(j, m);
    return tie == EdgeTie::beside    ? Conflict::defers
           : tie == EdgeTie::between ? Conflict::destroys
                                     : Conflict::none;
  }
};

// Triangle ijk. Cross products of differences below 2^30 stay below 2^61, and sums of three fit 63
// bits.
template <class Integer>
struct ExactCentre<2, Integer> {
  LiftedInt j, k;
  Vector3<std::int64_t> n;
  ALPHASCOPE_HOST_DEVICE explicit ExactCentre(const LiftedInt (&v)[2])
      : j(v[0]), k(v[1]), n(cross(j, k)) {}
  ALPHASCOPE_HOST_DEVICE bool regular() const { return n.x != 0 || n.y != 0 || n.z != 0; }
  ALPHASCOPE_HOST_DEVICE Conflict with(const LiftedInt& m) const {
    const int side = triangle_foot_cut(j, k, m);
    if (side != 0) return side > 0 ? Conflict::destroys : Conflict::none;
    if (determinant(j, k, m) != 0) return Conflict::defers;
    // m = lambda_j d_j + lambda_k d_k; the lambdas follow from one coordinate of m × k and j × m.
    const auto mk = cross(m, k), jm = cross(j, m);
    const std::int64_t whole = n.x != 0 ? n.x : n.y != 0 ? n.y : n.z;
    const std::int64_t a = n.x != 0 ? mk.x : n.y != 0 ? mk.y : mk.z;
    const std::int64_t b = n.x != 0 ? jm.x : n.y != 0 ? jm.y : jm.z;
    const int sign = sign_of(whole);
    HullTie tie{m, 1};
    tie.add(j, -sign_of(a) * sign);
    tie.add(k, -sign_of(b) * sign);
    tie.add({0, 0, 0, 0}, -sign_of(whole - a - b) * sign);
    return tie.sign < 0 ? Conflict::destroys : Conflict::none;
  }
};

// Tetrahedron ijkl by Cramer's rule, 2 x D = n. Ball m destroys it where (d_m·n - c_m D) D > 0. If
// |d_x| < 2^a and |c| < 2^b, d_m·n - c_m D is below 24 · 2^(3a + b). This is 2^118 for
// kInt128TupleOffset and any weights (a = 20, b = 53). It is 2^158 on the whole lattice (a = 30, b
// = 63).
inline constexpr std::int32_t kInt128TupleOffset = 1 << 20;

template <class Integer>
struct ExactCentre<3, Integer> {
  LiftedInt j, k, l;
  Integer d;
  Vector3<Integer> n;
  ALPHASCOPE_HOST_DEVICE explicit ExactCentre(const LiftedInt (&v)[3]) : j(v[0]), k(v[1]), l(v[2]) {
    const auto a = lifted_as<Integer>(j), b = lifted_as<Integer>(k), c = lifted_as<Integer>(l);
    const auto bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    d = dot(a, bc);
    n = {a.c * bc.x + b.c * ca.x + c.c * ab.x, a.c * bc.y + b.c * ca.y + c.c * ab.y,
         a.c * bc.z + b.c * ca.z + c.c * ab.z};
  }
  ALPHASCOPE_HOST_DEVICE bool regular() const { return sign_of(d) != 0; }
  ALPHASCOPE_HOST_DEVICE Conflict with(const LiftedInt& m) const {
    const auto v = lifted_as<Integer>(m);
    int side = sign_of(dot(v, n) - v.c * d) * sign_of(d);
    if (side == 0) side = perturbed_cut(j, k, false, l, false, m);
    return side > 0 ? Conflict::destroys : Conflict::none;
  }
};

}  // namespace alphascope
