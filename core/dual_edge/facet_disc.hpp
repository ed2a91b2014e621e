// SPDX-License-Identifier: GPL-3.0-or-later
// The disc in which the radical plane of i and j meets the grown ball i: { 2 d_j·x = c_j, |x|² <=
// w_i + alpha }. The facet ij of the power cell of i, where pi_i <= alpha, is the part of the disc
// that the other bisectors leave. In long lists of neighbours most discs are covered by a single
// ball. The disc's centre is the orthocentre of ij, which decides whether ij is attached. Each
// decided answer is certain; the other cases are decided elsewhere. Host and device; legend of
// dual_edge.hpp.
//
// A ball j whose disc is covered is in no simplex of K_alpha with i. If c > 0 for every neighbour,
// p_i is within its own cell, and then j is not even needed to bound the cell. Proof: go from p_i
// to a point that only covered balls cut off. The first of their planes would be crossed in a point
// of its disc that no ball cuts off.
#pragma once

#include "core/dual_edge/dual_edge.hpp"
#include "core/predicates/recording.hpp"

namespace alphascope {

template <class Real>
class FacetDisc {
 public:
  ALPHASCOPE_INLINE FacetDisc(const LiftedVector<Real>& j, Real radius_square) : j_(j) {
    inverse_ = 1 / (j.x * j.x + j.y * j.y + j.z * j.z);
    depth_ = Real(0.25) * j.c * j.c * inverse_;  // squared distance of the plane
    // depth_ errs by 3 u, radius_square by 3 u (LatticeAlpha::plus()), and the sums by 3 u of both.
    const Real error = kMargin * (radius_square + depth_);
    square_ = radius_square - depth_ + error;
    surely_ = radius_square - depth_ - error;
    own_error_ = 4 * kMargin * depth_;
  }

  ALPHASCOPE_INLINE bool certainly_empty() const { return square_ < 0; }
  // Is rho of the edge <= alpha?
  ALPHASCOPE_INLINE Decision centre_within() const {
    return square_ < 0 ? Decision::out : surely_ > 0 ? Decision::in : Decision::unknown;
  }

  // The numbers of ball m that covered_by() needs.
  struct Coverer {
    LiftedVector<Real> d;  // d.c is c_m plus the error of its part in `sure`
    Real length;           // upper bound on |d_m|²
  };
  ALPHASCOPE_INLINE static Coverer coverer(const LiftedVector<Real>& m) {
    const Real length = multiply_add(m.x, m.x, multiply_add(m.y, m.y, m.z * m.z));
    return {{m.x, m.y, m.z, m.c + kMargin * (length + magnitude(m.c))}, length + kMargin * length};
  }

  // Does ball m certainly cut off the whole disc? At the disc's centre x, 2 d_m·x - c_m is at least
  // `sure`. It falls by at most twice the disc's radius times the part of d_m across d_j. (A ball
  // does not cover its own disc.)
  ALPHASCOPE_INLINE bool covered_by(const Coverer& m) const {
    const Real along = multiply_add(m.d.x, j_.x, multiply_add(m.d.y, j_.y, m.d.z * j_.z));
    // share c_j errs by less than 12 u |d_m||c_j| / |d_j|. This is at most 6 u of the sum of |d_m|²
    // and c_j² / |d_j|². The margin is 16 u of that sum, and `across` allows 16 u of |d_m|².
    const Real share = along * inverse_;
    const Real sure = multiply_add(share, j_.c, -(m.d.c + own_error_));
    const Real across = multiply_add(-along, share, m.length);
    return sure > 0 && sure * sure > Real(4.0001) * across * square_;
  }

  // Does ball m cut off the disc's centre? `sink` gets pi_i - pi_m there, in square lattice units,
  // and its error.
  template <class Sink = NoSink>
  ALPHASCOPE_INLINE Decision centre_cut_by(const LiftedVector<Real>& m,
                                           const Sink& sink = {}) const {
    const Real along = multiply_add(m.x, j_.x, multiply_add(m.y, j_.y, m.z * j_.z));
    const Real length = multiply_add(m.x, m.x, multiply_add(m.y, m.y, m.z * m.z));
    const Real gap = along * inverse_ * j_.c - m.c;
    const Real error = kMargin * (length + magnitude(m.c)) + own_error_;
    sink(gap, error);
    return gap > error ? Decision::in : gap < -error ? Decision::out : Decision::unknown;
  }

 private:
  static constexpr Real kMargin = 16 * Rounding<Real>::u;

  LiftedVector<Real> j_;
  Real inverse_, depth_, own_error_;
  Real square_, surely_;  // squared radius of the disc: upper and lower bound
};

}  // namespace alphascope
