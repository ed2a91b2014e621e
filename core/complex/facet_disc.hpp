// The disc in which the radical plane of i and j meets the grown ball i: { 2 d_j·x = c_j, |x|² <=
// w_i + alpha }. Edge ij is in K_alpha only if some of its disc survives the other bisectors; most
// edges of long neighbour lists die because a single ball covers it all. Its centre is the
// orthocentre of ij, which decides whether ij is attached. What this says is certain, what it
// leaves is decided elsewhere. Host and device; legend of dual_edge.hpp.
#pragma once

#include "core/complex/dual_edge.hpp"

namespace alphascope {

template <class Real>
class FacetDisc {
 public:
  ALPHASCOPE_INLINE FacetDisc(const LiftedVector<Real>& j, Real radius_square) : j_(j) {
    inverse_ = 1 / (j.x * j.x + j.y * j.y + j.z * j.z);
    depth_ = Real(0.25) * j.c * j.c * inverse_;  // squared distance of the plane
    const Real error = kMargin * (radius_square + depth_);
    square_ = radius_square - depth_ + error;
    surely_ = radius_square - depth_ - error;
  }

  ALPHASCOPE_INLINE bool certainly_empty() const { return square_ < 0; }
  // Is rho of the edge <= alpha?
  ALPHASCOPE_INLINE Decision centre_within() const {
    return square_ < 0 ? Decision::out : surely_ > 0 ? Decision::in : Decision::unknown;
  }

  // What ball m does to the disc: certainly cuts off all of it; cuts off its centre.
  struct Cut {
    bool covers;
    Decision centre;
  };
  // At the disc's centre x, 2 d_m·x - c_m is `gap`; it falls by at most twice the disc's radius
  // times the part of d_m across d_j.
  ALPHASCOPE_INLINE Cut cut_by(const LiftedVector<Real>& m) const {
    const Real along = multiply_add(m.x, j_.x, multiply_add(m.y, j_.y, m.z * j_.z));
    const Real length = multiply_add(m.x, m.x, multiply_add(m.y, m.y, m.z * m.z));
    const Real share = along * inverse_;
    const Real across = length - along * share + kMargin * length;
    // `along` errs by 4 u |d_m||d_j|, so gap by less than 8 u (|d_m||c_j| / |d_j| + |c_m|), and the
    // first product is at most the mean of |d_m|² and c_j² / |d_j|².
    const Real size = length + 4 * depth_ + (m.c < 0 ? -m.c : m.c);
    const Real gap = share * j_.c - m.c, error = kMargin * size, sure = gap - error;
    return {sure > 0 && sure * sure > Real(4.0001) * across * square_, sure > 0 ? Decision::in
                                                                       : gap + error < 0
                                                                           ? Decision::out
                                                                           : Decision::unknown};
  }

 private:
  static constexpr Real kMargin = 16 * Rounding<Real>::u;
  LiftedVector<Real> j_;
  Real inverse_, depth_;
  Real square_, surely_;  // of the disc's radius: from above, from below
};

}  // namespace alphascope
