// Through which of its faces does a tetrahedron flow out: on which side of each face is its
// orthocentre? It is strictly beyond a face iff the opposite ball is strictly inside the face's
// smallest orthosphere, so this is also the attached test of the triangles. Host and device;
// notation of lifted.hpp.
#pragma once

#include "core/predicates/foot_predicate.hpp"
#include "core/predicates/perturbation.hpp"

namespace alphascope {

// What to do where the orthocentre lies in the plane of a face.
enum class FlowTies {
  perturbed,  // as the triangulation does: by the perturbation of the weights
  strict      // it does not flow
};

// For ball n of a tetrahedron, +1 where the orthocentre is strictly beyond the face opposite to it,
// -1 where it is strictly on the ball's side, and 0 where doubles do not decide. Within
// kBracketLimit.
//
// The barycentric coordinate of j is x·(d_k × d_l) / D = N·(d_k × d_l) / (2 D²) with N = 2x D;
// those of k and l likewise, and that of i is what they leave of 1. Terms of N carry 3 roundings,
// their products and sums 3 more; terms of D² carry 7, and 1 more each from the difference.
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
  // Below 3 · 2^51: exact.
  const Vector3<double> all{c.kl.x + c.lj.x + c.jk.x, c.kl.y + c.lj.y + c.jk.y,
                            c.kl.z + c.lj.z + c.jk.z};
  beyond[0] = side(2 * c.determinant * c.determinant - along_centre(all),
                   2 * c.size_of_determinant * c.size_of_determinant + size_along_centre(all));
  beyond[1] = side(along_centre(c.kl), size_along_centre(c.kl));
  beyond[2] = side(along_centre(c.lj), size_along_centre(c.lj));
  beyond[3] = side(along_centre(c.jk), size_along_centre(c.jk));
}

// The same of the face ijk opposite ball m, all lifted from i: exactly, 0 is a tie.
ALPHASCOPE_HOST_DEVICE inline int flow_side_exact(const LiftedInt& j, const LiftedInt& k,
                                                  const LiftedInt& m) {
  return triangle_foot_cut_exact(j, k, m);
}

// Where that is a tie.
ALPHASCOPE_HOST_DEVICE inline bool tied_flow(const LiftedInt& j, const LiftedInt& k,
                                             const LiftedInt& m, FlowTies ties) {
  return ties == FlowTies::perturbed && perturbed_triangle_foot_cut(j, k, m);
}

}  // namespace alphascope
