// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha value of one tetrahedron, and the faces through which it flows out. One of these is
// attached to it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/predicates/exact_alpha.hpp"
#include "core/predicates/flow_predicate.hpp"

namespace alphascope {

// Alpha value and outflow of one tetrahedron, with its balls lifted from the first one. The
// arguments must outlive it.
class TetrahedronFlow {
 public:
  TetrahedronFlow(const BallSet& balls, const std::array<BallIndex, 4>& simplex)
      : balls_(balls), simplex_(simplex), weight_(balls.weight(simplex[0])) {
    for (std::size_t n = 0; n < 3; ++n) v_[n] = lifted_vector(balls, simplex[0], simplex[n + 1]);
    if (!within_bracket_limit(v_[0]) || !within_bracket_limit(v_[1]) ||
        !within_bracket_limit(v_[2])) {
      return;
    }
    const TetrahedronCentre centre = tetrahedron_centre(
        lifted_as<double>(v_[0]), lifted_as<double>(v_[1]), lifted_as<double>(v_[2]));
    rho_ = tetrahedron_rho(centre, static_cast<double>(weight_));
    flow_sides_filtered(centre, beyond_);
  }

  float alpha_value() const {
    float rounded = 0;
    if (round_bracket(rho_, &rounded)) return rounded;
    return round_exact(exact_tetrahedron_rho(v_[0], v_[1], v_[2], weight_));
  }

  // The faces through which it flows out, as bits of Flow::marks. Counts exact ties in `tied`.
  std::uint8_t flow(FlowTies ties, std::size_t& tied) const {
    unsigned faces = 0;
    for (unsigned k = 0; k < 4; ++k) {
      if (beyond_[k] > 0 || (beyond_[k] == 0 && flows_exactly(k, ties, tied))) faces |= 1u << k;
    }
    return static_cast<std::uint8_t>(faces);
  }

 private:
  bool flows_exactly(unsigned k, FlowTies ties, std::size_t& tied) const {
    const BallIndex i = simplex_[k == 0 ? 1 : 0];
    const LiftedInt a = lifted_vector(balls_, i, simplex_[k < 2 ? 2 : 1]),
                    b = lifted_vector(balls_, i, simplex_[k < 3 ? 3 : 2]),
                    m = lifted_vector(balls_, i, simplex_[k]);
    const int side = flow_side_exact(a, b, m);
    if (side != 0) return side > 0;
    ++tied;
    return tied_flow(a, b, m, ties);
  }

  const BallSet& balls_;
  const std::array<BallIndex, 4>& simplex_;
  const std::int64_t weight_;
  LiftedInt v_[3];
  Bracket rho_{0, HUGE_VAL};
  signed char beyond_[4] = {0, 0, 0, 0};
};

}  // namespace alphascope
