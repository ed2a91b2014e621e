// Ortho-radii of simplices of one to four balls, and what they decide, on the lattice: bracketed in
// double precision with certified errors, and exactly in wide integers. Host and device.
//
// A simplex is given relative to its first ball i: every other ball k is its lifted vector
//   d = p_k - p_i,   c = |d|² + w_i - w_k,
// so that the bisector of i and k is { x : 2 d·x = c } with x measured from p_i, and ball k has
// less power distance than i where 2 d·x > c. The lattice bounds (lattice.hpp) give |d_x| < 2^30,
// |c| < 2^63; products below state the bits they need.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry/host_device.hpp"
#include "core/geometry/wide_int.hpp"

namespace alphascope {

template <class T>
struct LiftedVector {
  T x, y, z, c;
};
using LiftedInt = LiftedVector<std::int64_t>;

template <class T>
ALPHASCOPE_HOST_DEVICE LiftedVector<T> lifted_as(const LiftedInt& v) {
  return {T(v.x), T(v.y), T(v.z), T(v.c)};
}
template <>
ALPHASCOPE_HOST_DEVICE inline LiftedVector<double> lifted_as<double>(const LiftedInt& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z),
          static_cast<double>(v.c)};
}

template <class T>
struct Vector3 {
  T x, y, z;
};
template <class A, class B>
ALPHASCOPE_HOST_DEVICE auto cross(const A& a, const B& b) {
  return Vector3<decltype(a.x * b.x)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                      a.x * b.y - a.y * b.x};
}
template <class A, class B>
ALPHASCOPE_HOST_DEVICE auto dot(const A& a, const B& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The exact value lies between the doubles value - error and value + error, their own rounding
// included; an infinite error means "not known".
struct Bracket {
  double value;
  double error;
};

// Below this bound on |d_x| the double-precision brackets hold: |d|² < 3 · 2^50 and the coordinates
// of the cross product of two d, below 2^51, are exact as doubles, and so is c: weights are below
// 2^52, so |c| < 7 · 2^50.
inline constexpr std::int64_t kBracketLimit = std::int64_t{1} << 25;

inline constexpr double kUnitRoundoff = 1.1102230246251565e-16;  // 2^-53

ALPHASCOPE_HOST_DEVICE inline bool within_bracket_limit(const LiftedInt& v) {
  return v.x < kBracketLimit && v.x > -kBracketLimit && v.y < kBracketLimit &&
         v.y > -kBracketLimit && v.z < kBracketLimit && v.z > -kBracketLimit;
}

// Ortho-radius bracket from numerator and denominator brackets: P / Q - w, where P = |2x|² scaled.
ALPHASCOPE_HOST_DEVICE inline Bracket rho_bracket(double p, double p_error, double q,
                                                  double q_relative_error, double weight) {
  const double quotient = p / q;
  const double value = quotient - weight;
  // value is rounded, and so will be value -+ error. 1.01 covers the second-order terms and the
  // roundings of these sums themselves.
  const double error = 1.01 * (p_error / q * (1 + q_relative_error) +
                               quotient * (q_relative_error + 2 * kUnitRoundoff) +
                               2 * kUnitRoundoff * (value < 0 ? -value : value));
  return {value, error};
}

// rho of an edge: |x| = c / (2|d|). g = |d|² is exact. Equal weights give c = g and rho = g / 4 - w
// without any rounding below 2^51: worth its own line, since those often lie just between two
// floats. From there to 2^52, which it does not reach, doubles are halves, and rho may be a quarter
// off.
ALPHASCOPE_HOST_DEVICE inline Bracket edge_rho(const LiftedVector<double>& j, double weight) {
  const double g = dot(j, j);
  if (j.c == g) {
    const double value = 0.25 * g - weight;
    return {value, std::fabs(value) < 2251799813685248.0 ? 0 : 0.5};
  }
  const double p = j.c * j.c;
  return rho_bracket(p, kUnitRoundoff * p, 4 * g, 0, weight);
}

// rho of a triangle: |x|² = |c_j d_k - c_k d_j|² / (4 |d_j × d_k|²).
ALPHASCOPE_HOST_DEVICE inline Bracket triangle_rho(const LiftedVector<double>& j,
                                                   const LiftedVector<double>& k, double weight) {
  const auto n = cross(j, k);
  const double q = 4 * dot(n, n);
  if (!(q > 0)) return {0, HUGE_VAL};
  const double jx = j.c * k.x, jy = j.c * k.y, jz = j.c * k.z;
  const double kx = k.c * j.x, ky = k.c * j.y, kz = k.c * j.z;
  const double vx = jx - kx, vy = jy - ky, vz = jz - kz;
  const double u2 = 2 * kUnitRoundoff;
  const double ex = u2 * (std::fabs(jx) + std::fabs(kx)), ey = u2 * (std::fabs(jy) + std::fabs(ky)),
               ez = u2 * (std::fabs(jz) + std::fabs(kz));
  const double p = vx * vx + vy * vy + vz * vz;
  const double p_error = ex * (2 * std::fabs(vx) + ex) + ey * (2 * std::fabs(vy) + ey) +
                         ez * (2 * std::fabs(vz) + ez) + 3 * kUnitRoundoff * p;
  return rho_bracket(p, p_error, q, 4 * kUnitRoundoff, weight);
}

// rho of a tetrahedron by Cramer's rule: 2x D = c_j d_k×d_l + c_k d_l×d_j + c_l d_j×d_k.
ALPHASCOPE_HOST_DEVICE inline Bracket tetrahedron_rho(const LiftedVector<double>& j,
                                                      const LiftedVector<double>& k,
                                                      const LiftedVector<double>& l,
                                                      double weight) {
  const auto kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const double dx = j.x * kl.x, dy = j.y * kl.y, dz = j.z * kl.z;
  const double d = std::fabs(dx + dy + dz);
  const double d_error = 3 * kUnitRoundoff * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz));
  if (!(d > 2 * d_error)) return {0, HUGE_VAL};
  double p = 0, p_error = 0;
  const double cross_kl[3] = {kl.x, kl.y, kl.z}, cross_lj[3] = {lj.x, lj.y, lj.z},
               cross_jk[3] = {jk.x, jk.y, jk.z};
  for (int a = 0; a < 3; ++a) {
    const double t1 = j.c * cross_kl[a], t2 = k.c * cross_lj[a], t3 = l.c * cross_jk[a];
    const double n = t1 + t2 + t3;
    const double e = 3 * kUnitRoundoff * (std::fabs(t1) + std::fabs(t2) + std::fabs(t3));
    p += n * n;
    p_error += e * (2 * std::fabs(n) + e);
  }
  const double r = d_error / (d - d_error);
  return rho_bracket(p, p_error + 3 * kUnitRoundoff * p, 4 * d * d,
                     2 * r + r * r + 2 * kUnitRoundoff, weight);
}

// The exact ortho-radius as a fraction: rho = numerator / denominator, denominator > 0. All of them
// fit: of an edge, c² < 2^126 and 4 |d|² < 2^64; of a triangle, |n| < 2^61 in every direction,
// 4 n² < 2^126, |v| < 2^94; of a tetrahedron, |N| < 2^126, P < 2^254, |D| < 2^93; w < 2^52.
struct ExactRho {
  WideInt<4> numerator, denominator;
};

ALPHASCOPE_HOST_DEVICE inline ExactRho exact_rho(const WideInt<4>& p, const WideInt<4>& q,
                                                 std::int64_t weight) {
  return {p - q.times(weight), q};
}
ALPHASCOPE_HOST_DEVICE inline WideInt<4> square_of(const Vector3<Int128>& v) {
  return square_of(v.x) + square_of(v.y) + square_of(v.z);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_vertex_rho(std::int64_t weight) {
  return exact_rho(WideInt<4>(0), WideInt<4>(1), weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_edge_rho(const LiftedInt& j, std::int64_t weight) {
  return exact_rho(square_of(Int128{j.c}), WideInt<4>(dot(j, j)).times(4), weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_triangle_rho(const LiftedInt& j, const LiftedInt& k,
                                                          std::int64_t weight) {
  const Vector3<std::int64_t> n = cross(j, k);
  const auto combined = [&](std::int64_t a, std::int64_t b) {
    return Int128{j.c} * b - Int128{k.c} * a;
  };
  return exact_rho(square_of({combined(j.x, k.x), combined(j.y, k.y), combined(j.z, k.z)}),
                   square_of({2 * Int128{n.x}, 2 * Int128{n.y}, 2 * Int128{n.z}}), weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_tetrahedron_rho(const LiftedInt& j, const LiftedInt& k,
                                                             const LiftedInt& l,
                                                             std::int64_t weight) {
  const Vector3<std::int64_t> kl = cross(k, l), lj = cross(l, j), jk = cross(j, k);
  const Int128 d = Int128{j.x} * kl.x + Int128{j.y} * kl.y + Int128{j.z} * kl.z;
  const auto combined = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    return Int128{j.c} * a + Int128{k.c} * b + Int128{l.c} * c;
  };
  return exact_rho(square_of({combined(kl.x, lj.x, jk.x), combined(kl.y, lj.y, jk.y),
                              combined(kl.z, lj.z, jk.z)}),
                   square_of(2 * d), weight);
}

// Sign of rho - value, where value is any finite double that is a multiple of 2^-160.
ALPHASCOPE_HOST_DEVICE int compare_exact(const ExactRho& rho, double value);

// The float nearest to rho, halves to even; infinite beyond the largest float.
ALPHASCOPE_HOST_DEVICE float round_exact(const ExactRho& rho);

// Sign of rho - value from the bracket; 0 when the bracket does not decide.
ALPHASCOPE_HOST_DEVICE inline int compare_bracket(const Bracket& rho, double value) {
  if (rho.value - rho.error > value) return 1;
  if (rho.value + rho.error < value) return -1;
  return 0;
}

// True when every number within the bracket rounds to the same float, which is then *rounded.
ALPHASCOPE_HOST_DEVICE inline bool round_bracket(const Bracket& rho, float* rounded) {
  const float low = static_cast<float>(rho.value - rho.error);
  *rounded = static_cast<float>(rho.value + rho.error);
  return low == *rounded;
}

// ---- definitions of the two exact functions ----

ALPHASCOPE_HOST_DEVICE inline int compare_exact(const ExactRho& rho, double value) {
  // |rho| < 2^255: a larger value decides by its sign alone.
  if (value > 1e90) return -1;
  if (value < -1e90) return 1;
  int exponent = 0;
  const double fraction = frexp(value, &exponent);  // value = fraction · 2^exponent
  const std::int64_t mantissa = static_cast<std::int64_t>(ldexp(fraction, 53));
  exponent -= 53;
  if (mantissa == 0) return rho.numerator.sign();
  std::int64_t odd = mantissa;
  while ((odd & 1) == 0) {
    odd /= 2;
    ++exponent;
  }
  WideInt<8> left(rho.numerator), right = WideInt<8>(rho.denominator).times(odd);
  if (exponent >= 0) {
    right = right.shifted_left(exponent);
  } else {
    left = left.shifted_left(-exponent);
  }
  return (left - right).sign();
}

ALPHASCOPE_HOST_DEVICE inline float round_exact(const ExactRho& rho) {
  if (rho.numerator.sign() == 0) return 0.0f;
  const double approximate = rho.numerator.near_double() / rho.denominator.near_double();
  // Twice the relative error of the quotient; far smaller than half a float's spacing.
  const double slack = 16 * kUnitRoundoff * std::fabs(approximate);
  const float low = static_cast<float>(approximate - slack);
  const float high = static_cast<float>(approximate + slack);
  if (low == high) return low;
  if (std::isinf(low) || std::isinf(high)) {
    // The rounding boundary above the largest float F = 2^128 - 2^104 is 2^128 - 2^103.
    const double boundary = std::copysign(340282356779733661637539395458142568448.0, approximate);
    const int side = compare_exact(rho, boundary);
    if (approximate > 0) return side >= 0 ? high : low;
    return side <= 0 ? low : high;
  }
  // Two neighbouring floats: their mean is a double, and decides.
  const double middle = 0.5 * (static_cast<double>(low) + static_cast<double>(high));
  const int side = compare_exact(rho, middle);
  if (side != 0) return side < 0 ? low : high;
  return static_cast<float>(middle);  // a tie: the double-to-float conversion rounds it to even
}

}  // namespace alphascope
