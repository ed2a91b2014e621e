// SPDX-License-Identifier: GPL-3.0-or-later
// The dual edge of a triangle ijk: the part of the line { x : pi_i = pi_j = pi_k } that is left
// when the bisectors of i and its other neighbours have cut it. Its ends are the orthocentres of
// the tetrahedra ijkl. Single precision is the hot path of the GPU, as laptop GPUs have almost no
// double precision. Double precision is for the CPU, and for triangles that single precision leaves
// open. Every decision is certified or `unknown`; exact_dual_edge.hpp decides the unknown ones.
// power_line.hpp has the line, the legend and the cuts.
//
// Only the part with pi_i <= alpha matters: |x|² <= w_i + alpha.
//
// Source: Masood, Ray, Natarajan, Comput. Geom. 90 (2020), compute the alpha complex per simplex.
// Clipping the dual edge is our own: one interval, instead of a polygon or of one test for each
// 4-tuple and ball.
#pragma once

#include "core/dual_edge/power_line.hpp"
#include "core/predicates/rough_math.hpp"
#include "core/predicates/simplex_decisions.hpp"

namespace alphascope {

template <class Real>
class DualEdge : public PowerLine<Real> {
 public:
  using typename PowerLine<Real>::Cut;
  // An end of the edge, made by ball `cutter`: s = t at the high end and s = -t at the low end,
  // within `error`. cutter -1: no ball; the end is at the boundary of the disc, or slightly beyond.
  struct End {
    Real t, error;
    int cutter;
  };

  // Prepares the edge of triangle ijk before any cut. False when no point of the line has pi_i <=
  // alpha, or when the three centres are collinear (then ijk is no simplex). `radius_square` is w_i
  // + alpha in the units of the vectors squared; kLimit allows for its error.
  ALPHASCOPE_INLINE bool start(const LiftedVector<Real>& j, const LiftedVector<Real>& k,
                               Real radius_square) {
    if (!this->set(j, k)) return false;
    const Real f = largest_coordinate(foot_);
    square_error_ =
        foot_error_ * (6 * f + 3 * foot_error_) + kU * (5 * foot_square_ + kLimit * radius_square);
    const Real room = radius_square - foot_square_ + square_error_;
    if (room < 0) return false;
    const Real tiny = Real(1e-30);
    // The bound is above the radius of the disc on the line: q errs by 8 u, and there are a few
    // roundings.
    reach_ = rough_square_root((room <= tiny ? tiny : room) * 2 * half_inverse_) * Real(1.000003);
    high_ = low_ = {reach_, 0, -1};
    unsure_ = false;
    return true;
  }

  // A cheaper test than start(): true only when certainly no point of the line has pi_i <= alpha.
  ALPHASCOPE_INLINE static bool certainly_outside(const LiftedVector<Real>& j,
                                                  const LiftedVector<Real>& k, Real radius_square) {
    const Vector3<Real> n{j.y * k.z - j.z * k.y, j.z * k.x - j.x * k.z, j.x * k.y - j.y * k.x};
    const Vector3<Real> g{j.c * k.x - k.c * j.x, j.c * k.y - k.c * j.y, j.c * k.z - k.c * j.z};
    const Real jj = largest_coordinate(j), kk = largest_coordinate(k);
    // These are plain products. Each coordinate of n errs by 3 u of the bound on its two products,
    // each of g by 4 u.
    const Real n_error = 6 * kU * jj * kk,
               g_error = 4 * kU * (magnitude(j.c) * kk + magnitude(k.c) * jj);
    const Real n_square = multiply_add(n.x, n.x, multiply_add(n.y, n.y, n.z * n.z));
    const Real g_square = multiply_add(g.x, g.x, multiply_add(g.y, g.y, g.z * g.z));
    const Real n_sum = magnitude(n.x) + magnitude(n.y) + magnitude(n.z);
    const Real g_sum = magnitude(g.x) + magnitude(g.y) + magnitude(g.z);
    // |foot|² = |g|² / (4 |n|²).
    return g_square * (1 - 8 * kU) - 2 * g_error * g_sum >
           Real(4) * radius_square * (1 + 8 * kU) *
               (n_square + n_error * (2 * n_sum + 3 * n_error));
  }

  // The part of the remaining edge that a cut removes: certainly nothing, certainly all, or perhaps
  // some.
  enum class Takes { nothing, all, some };
  ALPHASCOPE_INLINE Takes takes(const Cut& cut) const {
    const Real farthest =
        multiply_add(magnitude(cut.slope) + cut.slope_error, reach_, cut.offset_error);
    return cut.offset > farthest    ? Takes::nothing
           : cut.offset < -farthest ? Takes::all
                                    : Takes::some;
  }

  // Cuts by ball `id`; true when nothing is left. A cut is skipped if its errors are too large to
  // decide about it; the edge is then unsure. Another cut may still remove everything.
  ALPHASCOPE_INLINE bool clip(const Cut& cut, int id) {
    const Real steepness = magnitude(cut.slope);
    const Real inverse = rough_reciprocal(steepness);
    const Real t = cut.offset * inverse;
    const Real size = magnitude(t);
    // The error of the quotient is (a - b t) / (slope - b) for errors a and b, |b| < |slope| / 8.
    const Real error = multiply_add(
        6 * kU, size, Real(1.15) * inverse * multiply_add(size, cut.slope_error, cut.offset_error));
    const bool above = cut.slope > 0;
    const End old = above ? high_ : low_;
    const Real gain = old.t - t, doubt = error + old.error;
    if (!(steepness > 8 * cut.slope_error) || !(magnitude(gain) > doubt || old.cutter < 0)) {
      unsure_ = true;
      return false;
    }
    // Near the boundary of the disc either answer is right, since within() judges the tetrahedron.
    // A NaN gain must not count as beyond the boundary, so the comparisons are written to be false
    // for NaN.
    if (old.cutter < 0 ? gain <= -error : gain < 0) return false;
    if (above) {
      high_ = {t, error, id};
    } else {
      low_ = {t, error, id};
    }
    // The new reach is that of the farther end. An end on the other side of the foot has t < 0 and
    // is the nearer one.
    const Real high_reach = high_.t + high_.error, low_reach = low_.t + low_.error;
    reach_ = Real(1.000003) * larger(high_reach, low_reach);
    return high_.t + low_.t < -(high_.error + low_.error);
  }

  // After all cuts: was every cut decided, so that both ends are certainly right?
  ALPHASCOPE_INLINE bool ends_certain() const { return !unsure_; }
  // Is the interval between the ends certainly not empty? An end at the disc's boundary does not
  // matter: within() then judges the other one.
  ALPHASCOPE_INLINE bool certainly_not_empty() const {
    return high_.cutter < 0 || low_.cutter < 0 || high_.t + low_.t > high_.error + low_.error;
  }

  // All of the remaining edge has |s| <= reach().
  ALPHASCOPE_INLINE Real reach() const { return reach_; }

  // The edge is x(s) with s from -low().t to high().t.
  ALPHASCOPE_INLINE const End& high() const { return high_; }
  ALPHASCOPE_INLINE const End& low() const { return low_; }

  // Does this end cut off the foot, so that ijk is attached to its tetrahedron?
  ALPHASCOPE_INLINE static Decision cuts_off_foot(const End& end) {
    return end.t > end.error    ? Decision::out
           : end.t < -end.error ? Decision::in
                                : Decision::unknown;
  }
  // Is rho of the triangle <= alpha?
  ALPHASCOPE_INLINE Decision foot_within(Real radius_square) const {
    if (foot_square_ + square_error_ < radius_square) return Decision::in;
    if (foot_square_ - square_error_ > radius_square) return Decision::out;
    return Decision::unknown;
  }
  // Is rho of the tetrahedron at this end <= alpha?
  ALPHASCOPE_INLINE Decision within(const End& end, Real radius_square) const {
    const Real along = end.t * end.t * q_;
    const Real square = along + foot_square_;
    const Real error = Real(1.01) * q_ * end.error * (2 * magnitude(end.t) + end.error) +
                       kU * (13 * along + 4 * square) + square_error_;
    if (square + error < radius_square) return Decision::in;
    if (square - error > radius_square) return Decision::out;
    return Decision::unknown;
  }

 private:
  using PowerLine<Real>::kU, PowerLine<Real>::q_, PowerLine<Real>::half_inverse_,
      PowerLine<Real>::foot_, PowerLine<Real>::foot_square_, PowerLine<Real>::foot_error_;
  // Error of radius_square in units of u, with two roundings of sums with it. Its own error is 3 u
  // in double (LatticeAlpha::plus()) and one rounding in single precision.
  static constexpr Real kLimit = sizeof(Real) == sizeof(float) ? 3 : 5;

  Real square_error_;
  Real reach_;
  bool unsure_;
  End high_, low_;  // low_.t = -s
};

}  // namespace alphascope
