// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha value of one tetrahedron, and the faces through which it flows out. One of these is
// attached to it. Host and device.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/predicates/flow_predicate.hpp"

namespace alphascope {

// Alpha value and outflow of one tetrahedron, with its balls lifted from the first one. `Corners`
// is as SimplexCorners (core/predicates/simplex_corners.hpp). The argument must outlive this.
template <class Corners>
class TetrahedronFlow {
 public:
  ALPHASCOPE_HOST_DEVICE explicit TetrahedronFlow(const Corners& corners)
      : corners_(corners),
        lifted_{{corners.lifted(0, 1), corners.lifted(0, 2), corners.lifted(0, 3)},
                corners.weight(0)} {
    if (!within_bracket_limit(lifted_)) return;
    const TetrahedronCentre centre =
        tetrahedron_centre(lifted_as<double>(lifted_.v[0]), lifted_as<double>(lifted_.v[1]),
                           lifted_as<double>(lifted_.v[2]));
    rho_ = tetrahedron_rho(centre, static_cast<double>(lifted_.weight));
    flow_sides_filtered(centre, beyond_);
  }

  ALPHASCOPE_HOST_DEVICE float alpha_value() const {
    float rounded = 0;
    return round_bracket(rho_, &rounded) ? rounded : exact_rounded_rho(lifted_);
  }

  // The faces through which it flows out, as bits of Flow::marks. Counts exact ties in `tied`.
  ALPHASCOPE_HOST_DEVICE std::uint8_t flow(FlowTies ties, std::uint32_t& tied) const {
    unsigned faces = 0;
    for (unsigned k = 0; k < 4; ++k) {
      if (beyond_[k] > 0 || (beyond_[k] == 0 && flows_exactly(corners_, k, ties, tied)))
        faces |= 1u << k;
    }
    return static_cast<std::uint8_t>(faces);
  }

 private:
  static ALPHASCOPE_DEVICE_CALL bool flows_exactly(const Corners& corners, unsigned k,
                                                   FlowTies ties, std::uint32_t& tied) {
    const unsigned i = k == 0 ? 1 : 0;
    const LiftedInt a = corners.lifted(i, k < 2 ? 2 : 1), b = corners.lifted(i, k < 3 ? 3 : 2),
                    m = corners.lifted(i, k);
    const int side = flow_side_exact(a, b, m);
    if (side != 0) return side > 0;
    ++tied;
    return tied_flow(a, b, m, ties);
  }

  const Corners& corners_;
  const LiftedSimplex<4> lifted_;
  Bracket rho_{0, HUGE_VAL};
  signed char beyond_[4] = {0, 0, 0, 0};
};

}  // namespace alphascope
