// SPDX-License-Identifier: GPL-3.0-or-later
// A test whether cuts certainly leave nothing of a dual edge. It takes half the work of
// DualEdge::clip(), which also finds the ends. Most triangles of three balls that meet are no
// simplices, and this test rejects them early. Host and device, but only the CUDA executor calls
// it: the CPU clips at once. Legend of dual_edge.hpp.
#pragma once

#include "core/dual_edge/dual_edge.hpp"

namespace alphascope {

template <class Real>
class DualEdgeProbe {
 public:
  // Requires an edge after start(), and vectors with |x| + |y| + |z| <= length and |c| <= power.
  ALPHASCOPE_INLINE DualEdgeProbe(const DualEdge<Real>& edge, Real length, Real power)
      : edge_(edge),
        slope_error_(length * edge.slope_error()),
        offset_error_(length * edge.offset_error() + Real(2.6) * kU * power),
        high_(edge.reach()),
        low_(edge.reach()) {}

  // Cuts by ball m. True when nothing is left, after this cut or an earlier one.
  ALPHASCOPE_INLINE bool clip(const LiftedVector<Real>& m) {
    const auto [slope, offset] = edge_.line_cut(m);
    const Real steepness = magnitude(slope);
    // The end is at most (offset + its error) / (steepness -+ its error). The computed quotient
    // errs by less than 8 u. A cut that is not steep enough is skipped.
    const Real most = offset + offset_error_;
    const Real least_steep = most < 0 ? steepness + slope_error_ : steepness - slope_error_;
    const Real quotient = most * rough_reciprocal(least_steep);
    const Real end = multiply_add(magnitude(quotient), 10 * kU, quotient);
    const Real enough = 8 * slope_error_;
    if (slope > enough && end < high_) high_ = end;
    if (slope < -enough && end < low_) low_ = end;
    const Real farthest = multiply_add(steepness + slope_error_, edge_.reach(), offset_error_);
    return high_ + low_ < 0 || offset < -farthest;
  }

 private:
  static constexpr Real kU = Rounding<Real>::u;
  const DualEdge<Real>& edge_;
  const Real slope_error_, offset_error_;
  Real high_, low_;  // upper bounds on the ends, as DualEdge::End::t
};

}  // namespace alphascope
