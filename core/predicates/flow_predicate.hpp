// SPDX-License-Identifier: GPL-3.0-or-later
// Decides through which of its faces a tetrahedron flows out: on which side of each face its
// orthocentre is. The orthocentre is strictly beyond a face iff the opposite ball is strictly
// inside the face's smallest orthosphere. So this is also the test whether the triangle is
// attached. Host and device; notation of lifted.hpp.
#pragma once

#include "core/predicates/flow_ties.hpp"
#include "core/predicates/foot_predicate.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

// Sets beyond[n] for ball n. It is +1 where the orthocentre is strictly beyond the face opposite to
// n, -1 where it is strictly on n's side, and 0 where doubles do not decide. All vectors must be
// within kBracketLimit.
//
// The barycentric coordinate of j is x·(d_k × d_l) / D = N·(d_k × d_l) / (2 D²) with N = 2x D.
// Those of k and l are similar, and that of i is 1 less the sum of the three. Terms of N carry 3
// roundings, their products and sums 3 more. Terms of D² carry 7, and the difference adds 1 to
// each.
ALPHASCOPE_HOST_DEVICE inline void flow_sides_filtered(const TetrahedronCentre& c,
                                                       signed char (&beyond)[4]) {
  const auto side = [](double coordinate, double size) -> signed char {
    const double error = 10 * kUnitRoundoff * size;
    return coordinate < -error ? 1 : coordinate > error ? -1 : 0;
  };
  const auto along_centre = [&](const Vector3<double>& v) { return dot(c.numerator, v); };
  const auto size_along_centre = [&](const Vector3<double>& v) {
    return c.size.x * std::fabs(v.x) + c.size.y * std::fabs(v.y) + c.size.z * std::fabs(v.z);
  };
  // The sums are below 3 · 2^51, so they are exact.
  const Vector3<double> all{c.kl.x + c.lj.x + c.jk.x, c.kl.y + c.lj.y + c.jk.y,
                            c.kl.z + c.lj.z + c.jk.z};
  beyond[0] = side(2 * c.determinant * c.determinant - along_centre(all),
                   2 * c.size_of_determinant * c.size_of_determinant + size_along_centre(all));
  beyond[1] = side(along_centre(c.kl), size_along_centre(c.kl));
  beyond[2] = side(along_centre(c.lj), size_along_centre(c.lj));
  beyond[3] = side(along_centre(c.jk), size_along_centre(c.jk));
}

// The side of the face ijk opposite ball m as an exact sign; 0 is a tie. All are lifted from i.
ALPHASCOPE_HOST_DEVICE inline int flow_side_exact(const LiftedInt& j, const LiftedInt& k,
                                                  const LiftedInt& m) {
  return triangle_foot_cut_exact(j, k, m);
}

// Is there flow through face ijk when flow_side_exact() is 0?
ALPHASCOPE_HOST_DEVICE inline bool tied_flow(const LiftedInt& j, const LiftedInt& k,
                                             const LiftedInt& m, FlowTies ties) {
  return ties == FlowTies::perturbed && perturbed_triangle_foot_cut(j, k, m);
}

}  // namespace alphascope
