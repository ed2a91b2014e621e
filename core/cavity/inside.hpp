// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of a tetrahedron that follow from the flow, at every alpha at which it is empty.
#pragma once

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/tetrahedron_order.hpp"
#include "core/predicates/exact_alpha.hpp"

namespace alphascope {

// Returns whether an empty tetrahedron is part of a void or a pocket.
inline bool is_inside_if_empty(const Flow& flow, std::size_t t, OutsideRule rule) {
  return rule == OutsideRule::castp ? (flow.marks[t] & Flow::kReachesSink) != 0
                                    : (flow.marks[t] & Flow::kReachesInfinity) == 0;
}

// Returns whether sink a has a larger ortho-radius than sink b. Exact. Equal ones are ordered by
// their centres.
inline bool is_deeper_sink(const CavityGround& ground, std::uint32_t a, std::uint32_t b) {
  const float of_a = ground.flow.alpha_values[a], of_b = ground.flow.alpha_values[b];
  if (of_a != of_b) return of_a > of_b;
  const auto& tetrahedra = ground.triangulation->tetrahedra;
  const int side = compare_ortho_radii(*ground.balls, tetrahedra[a], tetrahedra[b]);
  return side != 0 ? side > 0 : comes_first(*ground.balls, tetrahedra[a], tetrahedra[b]);
}

}  // namespace alphascope
