// SPDX-License-Identifier: GPL-3.0-or-later
// The line of equal power of a triangle ijk, and where another ball cuts it, with error bounds. One
// template body serves single and double precision.
//
// Legend (origin p_i; lifted vectors (d, c) as in core/predicates/lifted.hpp; u: unit roundoff):
//   line     x(s) = foot + s n,  n = d_j × d_k,  foot = g × n / (2 |n|²),  g = c_j d_k - c_k d_j
//   ball m   cuts off 2 d_m·x > c_m, which is s (d_m·n) > c_m / 2 - d_m·foot
//   N, F, P, G  largest coordinates of n, foot, g × n, g
#pragma once

#include "core/predicates/lifted.hpp"
#include "core/predicates/rough_math.hpp"
#include "core/predicates/rounding.hpp"

namespace alphascope {

// a b - c d within 2 u of its value. Single precision: the method of W. Kahan, see C.-P. Jeannerod
// et al., Math. Comp. 82 (2013). Double precision: exact for coordinates of d, which are integers
// below 2^25.
ALPHASCOPE_INLINE float difference_of_products(float a, float b, float c, float d) {
  const float product = c * d;
  return fmaf(a, b, -product) + fmaf(-c, d, product);
}
ALPHASCOPE_INLINE double difference_of_products(double a, double b, double c, double d) {
  return a * b - c * d;
}

// The same within 2 u for any coordinates, by the method for single precision.
ALPHASCOPE_INLINE double wide_difference_of_products(double a, double b, double c, double d) {
  const double product = c * d;
  return fma(a, b, -product) + fma(-c, d, product);
}

// a b + c, by fma where that is one instruction. The error bounds hold either way.
ALPHASCOPE_INLINE float multiply_add(float a, float b, float c) {
  return fmaf(a, b, c);
}
ALPHASCOPE_INLINE double multiply_add(double a, double b, double c) {
  return a * b + c;
}

template <class Vector>
ALPHASCOPE_INLINE auto largest_coordinate(const Vector& v) {
  return larger(larger(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}

// kWide: double precision for coordinates of d beyond 2^25, with an fma that hosts may lack.
template <class Real, bool kWide = false>
class PowerLine {
 public:
  // Prepares the line. False when the three centres are collinear or nearly so.
  ALPHASCOPE_INLINE bool set(const LiftedVector<Real>& j, const LiftedVector<Real>& k) {
    const auto difference = [](Real a, Real b, Real c, Real d) {
      if constexpr (kWide) {
        return wide_difference_of_products(a, b, c, d);
      } else {
        return difference_of_products(a, b, c, d);
      }
    };
    n_ = {difference(j.y, k.z, j.z, k.y), difference(j.z, k.x, j.x, k.z),
          difference(j.x, k.y, j.y, k.x)};
    q_ = multiply_add(n_.x, n_.x, multiply_add(n_.y, n_.y, n_.z * n_.z));
    if (!(q_ > 0)) return false;
    const Vector3<Real> g{j.c * k.x - k.c * j.x, j.c * k.y - k.c * j.y, j.c * k.z - k.c * j.z};
    const Vector3<Real> p{g.y * n_.z - g.z * n_.y, g.z * n_.x - g.x * n_.z,
                          g.x * n_.y - g.y * n_.x};
    half_inverse_ = Real(0.5) * rough_reciprocal(q_);
    const Real r = half_inverse_;
    foot_ = {p.x * r, p.y * r, p.z * r};
    // Each product of g errs by 2 u (one from c), its difference by u. n errs by 2 u. Each product
    // of p errs by u, its difference by u. 1/|n|² errs by 12 u.
    const Real n = largest_coordinate(n_), f = largest_coordinate(foot_),
               size = largest_coordinate(g);
    const Real products =
        magnitude(j.c) * largest_coordinate(k) + magnitude(k.c) * largest_coordinate(j);
    const Real g_error = kU * (2 * products + size);
    foot_error_ = Real(1.01) * r * n * (2 * g_error + Real(6.1) * kU * size) + 15 * kU * f;
    slope_error_ = Real(5.1) * kU * n;
    offset_error_ = foot_error_ + Real(5.1) * kU * f;
    foot_square_ =
        multiply_add(foot_.x, foot_.x, multiply_add(foot_.y, foot_.y, foot_.z * foot_.z));
    return true;
  }

  // The cut of ball m at s · slope = offset, without error bounds.
  struct LineCut {
    Real slope, offset;
  };
  ALPHASCOPE_INLINE LineCut line_cut(const LiftedVector<Real>& m) const {
    return {
        multiply_add(m.x, n_.x, multiply_add(m.y, n_.y, m.z * n_.z)),
        multiply_add(-m.x, foot_.x,
                     multiply_add(-m.y, foot_.y, multiply_add(-m.z, foot_.z, Real(0.5) * m.c)))};
  }
  // The cut of ball m: s (d_m·n) = c_m / 2 - d_m·foot, that is s · slope = offset, each with its
  // error.
  struct Cut {
    Real slope, offset, slope_error, offset_error;
  };
  ALPHASCOPE_INLINE Cut cut_by(const LiftedVector<Real>& m) const {
    const Real length = magnitude(m.x) + magnitude(m.y) + magnitude(m.z);
    const LineCut cut = line_cut(m);
    return {cut.slope, cut.offset, length * slope_error_,
            multiply_add(Real(2.6) * kU, magnitude(m.c), length * offset_error_)};
  }

  // Errors of slope and offset in line_cut(), per |x| + |y| + |z| of the vector. The offset errs by
  // 2.6 u |c| in addition.
  ALPHASCOPE_INLINE Real slope_error() const { return slope_error_; }
  ALPHASCOPE_INLINE Real offset_error() const { return offset_error_; }
  // x(s) = foot() + s direction(), measured from p_i. Each coordinate of foot() errs by at most
  // foot_error(), each of direction() by 2 u of its value.
  ALPHASCOPE_INLINE const Vector3<Real>& foot() const { return foot_; }
  ALPHASCOPE_INLINE const Vector3<Real>& direction() const { return n_; }
  ALPHASCOPE_INLINE Real foot_error() const { return foot_error_; }
  ALPHASCOPE_INLINE Real direction_square() const { return q_; }

 protected:
  static constexpr Real kU = Rounding<Real>::u;

  Vector3<Real> n_, foot_;
  Real q_, half_inverse_;  // |n|², 1 / (2 |n|²)
  Real foot_square_;
  Real foot_error_;
  Real slope_error_, offset_error_;  // per length of d_m
};

}  // namespace alphascope
