// The tetrahedra at the ends of a dual edge in exact integers, for the triangles that dual_edge.hpp
// leaves open. Host and device.
#pragma once

#include "core/complex/facet_complex.hpp"
#include "core/geometry/perturbation.hpp"

namespace alphascope {

// Int128 holds orthocentre_cut for |d_x| < 2^17 and |c| < 2^36: |d_j × d_k| < 2^35, its products
// with c and d_m < 2^88, twelve of them < 2^92. WideInt<4> holds it for every lattice: 2^61, 2^154.
inline constexpr std::int64_t kSmallOffset = std::int64_t{1} << 17,
                              kSmallPower = std::int64_t{1} << 36;

// +1 when ball m cuts off the orthocentre x of ijkl, else -1; ties broken by the perturbation. With
// D = det(d_j, d_k, d_l), not 0: 2 D x = c_j d_k × d_l + c_k d_l × d_j + c_l d_j × d_k.
template <class Integer>
ALPHASCOPE_HOST_DEVICE int orthocentre_cut(const LiftedInt& j, const LiftedInt& k,
                                           const LiftedInt& l, const LiftedInt& m) {
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const Integer cj(j.c), ck(k.c), cl(l.c);
  const Integer d =
      Integer(j.x) * Integer(kl.x) + Integer(j.y) * Integer(kl.y) + Integer(j.z) * Integer(kl.z);
  const Integer x = cj * Integer(kl.x) + ck * Integer(lj.x) + cl * Integer(jk.x);
  const Integer y = cj * Integer(kl.y) + ck * Integer(lj.y) + cl * Integer(jk.y);
  const Integer z = cj * Integer(kl.z) + ck * Integer(lj.z) + cl * Integer(jk.z);
  const Integer beyond = Integer(m.x) * x + Integer(m.y) * y + Integer(m.z) * z - Integer(m.c) * d;
  const int sign = sign_of(beyond) * sign_of(d);
  return sign != 0 ? sign : perturbed_cut(j, k, false, l, false, m);
}

// The ball that ends the dual edge of ijk on one side (+1: along d_j × d_k) if its tetrahedron is
// in K_alpha, else -1. `next(m)` is the common neighbour of i, j and k after m, from next(-1) on,
// or -1. `k` and results are slots of in.neighbours.
template <class Integer, class Neighbours, class Next>
ALPHASCOPE_HOST_DEVICE int exact_end(const FacetInput<Neighbours>& in, int k, int side,
                                     const Next& next) {
  const LiftedInt vj = in.neighbours.lifted(in.j), vk = in.neighbours.lifted(k);
  int end = -1;
  LiftedInt v_end{};
  for (int m = next(-1); m >= 0; m = next(m)) {
    const LiftedInt vm = in.neighbours.lifted(m);
    if (sign_of(determinant(vj, vk, vm)) != side) continue;
    if (end >= 0 && orthocentre_cut<Integer>(vj, vk, v_end, vm) < 0) continue;
    end = m;
    v_end = vm;
  }
  if (end < 0) return -1;
  // Those that bound the other side, or run parallel, may have cut off everything.
  for (int m = next(-1); m >= 0; m = next(m)) {
    if (m != end && orthocentre_cut<Integer>(vj, vk, v_end, in.neighbours.lifted(m)) > 0) return -1;
  }
  return decide_tetrahedron<ExactDecider>(in, k, end, nullptr) == Decision::in ? end : -1;
}

}  // namespace alphascope
