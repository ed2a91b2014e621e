// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a ball's bisector the orthocentre of a tetrahedron is, in exact integers. Host
// and device.
#pragma once

#include "core/predicates/perturbation.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {

// Int128 is wide enough for orthocentre_cut() if |d_x| < 2^17 and |c| < 2^36: then |d_j × d_k| <
// 2^35, its products with c and d_m are < 2^88, and twelve of them < 2^92. WideInt<4> is wide
// enough for every lattice: 2^61 and 2^154.
inline constexpr std::int64_t kSmallOffset = std::int64_t{1} << 17,
                              kSmallPower = std::int64_t{1} << 36;

// A ball that ends a dual edge. Slot -1 is a ghost: a plane without weight, beyond all points with
// pi_i <= alpha.
struct EndBall {
  int slot;
  LiftedInt lifted;
};

// +1 when ball m cuts off the orthocentre x of ijkl, else -1; the perturbation breaks ties. With
// D = det(d_j, d_k, d_l), not 0: 2 D x = c_j d_k × d_l + c_k d_l × d_j + c_l d_j × d_k.
template <class Integer>
ALPHASCOPE_HOST_DEVICE int orthocentre_cut(const LiftedInt& j, const LiftedInt& k,
                                           const EndBall& end, const LiftedInt& m) {
  const LiftedInt& l = end.lifted;
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const Integer cj(j.c), ck(k.c), cl(l.c);
  const Integer d =
      Integer(j.x) * Integer(kl.x) + Integer(j.y) * Integer(kl.y) + Integer(j.z) * Integer(kl.z);
  const Integer x = cj * Integer(kl.x) + ck * Integer(lj.x) + cl * Integer(jk.x);
  const Integer y = cj * Integer(kl.y) + ck * Integer(lj.y) + cl * Integer(jk.y);
  const Integer z = cj * Integer(kl.z) + ck * Integer(lj.z) + cl * Integer(jk.z);
  const Integer beyond = Integer(m.x) * x + Integer(m.y) * y + Integer(m.z) * z - Integer(m.c) * d;
  const int sign = sign_of(beyond) * sign_of(d);
  return sign != 0 ? sign : perturbed_cut(j, k, false, l, end.slot < 0, m);
}

}  // namespace alphascope
