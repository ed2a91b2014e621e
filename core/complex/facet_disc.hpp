// The disc in which the radical plane of i and j meets the grown ball i: { 2 d_j·x = c_j, |x|² <=
// w_i + alpha }. Edge ij is in K_alpha only if some of its disc survives the other bisectors; most
// edges of long neighbour lists die because a single ball covers it all. A cull: what it says is
// certain, what it leaves is decided elsewhere. Host and device; legend of dual_edge.hpp.
#pragma once

#include "core/complex/dual_edge.hpp"

namespace alphascope {

template <class Real>
class FacetDisc {
 public:
  ALPHASCOPE_INLINE FacetDisc(const LiftedVector<Real>& j, Real radius_square) : j_(j) {
    inverse_ = 1 / (j.x * j.x + j.y * j.y + j.z * j.z);
    depth_ = Real(0.25) * j.c * j.c * inverse_;  // squared distance of the plane
    square_ = radius_square - depth_ + kMargin * (radius_square + depth_);
  }

  ALPHASCOPE_INLINE bool certainly_empty() const { return square_ < 0; }

  // Does ball m certainly cut off all of the disc? At its centre x, 2 d_m·x - c_m is `gap`; it
  // falls by at most twice the disc's radius times the part of d_m across d_j.
  ALPHASCOPE_INLINE bool certainly_covered_by(const LiftedVector<Real>& m) const {
    const Real along = multiply_add(m.x, j_.x, multiply_add(m.y, j_.y, m.z * j_.z));
    const Real length = multiply_add(m.x, m.x, multiply_add(m.y, m.y, m.z * m.z));
    const Real share = along * inverse_;
    const Real across = length - along * share + kMargin * length;
    // `along` errs by 4 u |d_m||d_j|, so gap by less than 8 u (|d_m||c_j| / |d_j| + |c_m|), and the
    // first product is at most the mean of |d_m|² and c_j² / |d_j|².
    const Real size = length + 4 * depth_ + (m.c < 0 ? -m.c : m.c);
    const Real gap = share * j_.c - m.c - kMargin * size;
    return gap > 0 && gap * gap > Real(4.0001) * across * square_;
  }

 private:
  static constexpr Real kMargin = 16 * Rounding<Real>::u;
  LiftedVector<Real> j_;
  Real inverse_, depth_, square_;
};

}  // namespace alphascope
