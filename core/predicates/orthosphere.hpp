// SPDX-License-Identifier: GPL-3.0-or-later
// Ortho-radii of simplices of one to four balls on the lattice, bracketed in double precision with
// certified errors. exact_rho.hpp has them in wide integers. Host and device; notation of
// lifted.hpp. Comments at products state the bits that they need.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/predicates/exact_rho.hpp"
#include "core/predicates/lifted.hpp"

namespace alphascope {

// The exact value lies between the doubles value - error and value + error, as they are after
// rounding. An infinite error means that the bracket decides nothing.
struct Bracket {
  double value;
  double error;
};

// The bracket of the ortho-radius |x|² - w = P / Q - w, from brackets of P and Q.
ALPHASCOPE_HOST_DEVICE inline Bracket quotient_minus_weight(double p, double p_error, double q,
                                                            double q_relative_error,
                                                            double weight) {
  const double quotient = p / q;
  const double value = quotient - weight;
  // `value` is rounded, and so are value - error and value + error. The factor 1.01 covers terms of
  // second order and the roundings of these sums themselves.
  const double error = 1.01 * (p_error / q * (1 + q_relative_error) +
                               quotient * (q_relative_error + 2 * kUnitRoundoff) +
                               2 * kUnitRoundoff * (value < 0 ? -value : value));
  return {value, error};
}

// rho of an edge: |x| = c / (2|d|). g = |d|² is exact. Equal weights give c = g and rho = g / 4 -
// w, without any rounding below 2^51. They have a branch of their own because such values often lie
// halfway between two floats. From 2^51 to 2^52, which rho does not reach, doubles are multiples of
// 1/2, so rho may err by 1/4.
ALPHASCOPE_HOST_DEVICE inline Bracket edge_rho(const LiftedVector<double>& j, double weight) {
  const double g = dot(j, j);
  if (j.c == g) {
    const double value = 0.25 * g - weight;
    return {value, std::fabs(value) < 2251799813685248.0 ? 0 : 0.5};
  }
  const double p = j.c * j.c;
  return quotient_minus_weight(p, kUnitRoundoff * p, 4 * g, 0, weight);
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
  return quotient_minus_weight(p, p_error, q, 4 * kUnitRoundoff, weight);
}

// The orthocentre x of a tetrahedron by Cramer's rule: 2x D = c_j d_k×d_l + c_k d_l×d_j + c_l
// d_j×d_k.
struct TetrahedronCentre {
  Vector3<double> kl, lj, jk;       // the cross products: exact
  Vector3<double> numerator, size;  // 2x D, and the sum of its terms' absolute values
  double determinant, size_of_determinant;

  // Every term of the numerator and of D carries at most 3 roundings.
  ALPHASCOPE_HOST_DEVICE static double error(double size_of_terms) {
    return 3 * kUnitRoundoff * size_of_terms;
  }
};
ALPHASCOPE_HOST_DEVICE inline TetrahedronCentre tetrahedron_centre(const LiftedVector<double>& j,
                                                                   const LiftedVector<double>& k,
                                                                   const LiftedVector<double>& l) {
  TetrahedronCentre c{cross(k, l), cross(l, j), cross(j, k), {}, {}, 0, 0};
  const double dx = j.x * c.kl.x, dy = j.y * c.kl.y, dz = j.z * c.kl.z;
  c.determinant = dx + dy + dz;
  c.size_of_determinant = std::fabs(dx) + std::fabs(dy) + std::fabs(dz);
  const auto combine = [&](double kl, double lj, double jk, double& sum, double& size) {
    const double t1 = j.c * kl, t2 = k.c * lj, t3 = l.c * jk;
    sum = t1 + t2 + t3;
    size = std::fabs(t1) + std::fabs(t2) + std::fabs(t3);
  };
  combine(c.kl.x, c.lj.x, c.jk.x, c.numerator.x, c.size.x);
  combine(c.kl.y, c.lj.y, c.jk.y, c.numerator.y, c.size.y);
  combine(c.kl.z, c.lj.z, c.jk.z, c.numerator.z, c.size.z);
  return c;
}

// rho of a tetrahedron.
ALPHASCOPE_HOST_DEVICE inline Bracket tetrahedron_rho(const TetrahedronCentre& centre,
                                                      double weight) {
  const double d = std::fabs(centre.determinant);
  const double d_error = TetrahedronCentre::error(centre.size_of_determinant);
  if (!(d > 2 * d_error)) return {0, HUGE_VAL};
  double p = 0, p_error = 0;
  const auto add = [&](double n, double size) {
    const double e = TetrahedronCentre::error(size);
    p += n * n;
    p_error += e * (2 * std::fabs(n) + e);
  };
  add(centre.numerator.x, centre.size.x);
  add(centre.numerator.y, centre.size.y);
  add(centre.numerator.z, centre.size.z);
  const double r = d_error / (d - d_error);
  return quotient_minus_weight(p, p_error + 3 * kUnitRoundoff * p, 4 * d * d,
                               2 * r + r * r + 2 * kUnitRoundoff, weight);
}
ALPHASCOPE_HOST_DEVICE inline Bracket tetrahedron_rho(const LiftedVector<double>& j,
                                                      const LiftedVector<double>& k,
                                                      const LiftedVector<double>& l,
                                                      double weight) {
  return tetrahedron_rho(tetrahedron_centre(j, k, l), weight);
}

// rho of a simplex of any dimension; its vectors must be within kBracketLimit.
ALPHASCOPE_HOST_DEVICE inline Bracket rho_bracket(const LiftedSimplex<1>& s) {
  return {-static_cast<double>(s.weight), 0};
}
ALPHASCOPE_HOST_DEVICE inline Bracket rho_bracket(const LiftedSimplex<2>& s) {
  return edge_rho(lifted_as<double>(s.v[0]), static_cast<double>(s.weight));
}
ALPHASCOPE_HOST_DEVICE inline Bracket rho_bracket(const LiftedSimplex<3>& s) {
  return triangle_rho(lifted_as<double>(s.v[0]), lifted_as<double>(s.v[1]),
                      static_cast<double>(s.weight));
}
ALPHASCOPE_HOST_DEVICE inline Bracket rho_bracket(const LiftedSimplex<4>& s) {
  return tetrahedron_rho(lifted_as<double>(s.v[0]), lifted_as<double>(s.v[1]),
                         lifted_as<double>(s.v[2]), static_cast<double>(s.weight));
}
// The same, with an infinite error where `brackets_hold` is false.
template <int N>
ALPHASCOPE_HOST_DEVICE Bracket rho_bracket(const LiftedSimplex<N>& s, bool brackets_hold) {
  return brackets_hold ? rho_bracket(s) : Bracket{0, HUGE_VAL};
}

// Sign of rho - alpha, or 0 when the bracket does not decide. The rounding of alpha adds no error:
// alpha lies between the doubles `below` and `above`, and the bracket must lie beyond one of them.
ALPHASCOPE_HOST_DEVICE inline int compare_bracket(const Bracket& rho, const LatticeAlpha& alpha) {
  if (rho.value - rho.error > alpha.above) return 1;
  if (rho.value + rho.error < alpha.below) return -1;
  return 0;
}

// True when all numbers within the bracket round to the same float; *rounded is then that float.
ALPHASCOPE_HOST_DEVICE inline bool round_bracket(const Bracket& rho, float* rounded) {
  const float low = static_cast<float>(rho.value - rho.error);
  *rounded = static_cast<float>(rho.value + rho.error);
  return low == *rounded;
}

// Sign of rho - alpha, in integers.
template <int N>
ALPHASCOPE_DEVICE_CALL int compare_rho_exactly(const LiftedSimplex<N>& s,
                                               const LatticeAlpha& alpha) {
  return compare_exact(exact_rho(s), alpha);
}
// Sign of rho - alpha.
template <int N>
ALPHASCOPE_HOST_DEVICE int compare_rho(const LiftedSimplex<N>& s, const LatticeAlpha& alpha) {
  const int side = compare_bracket(rho_bracket(s, within_bracket_limit(s)), alpha);
  return side != 0 ? side : compare_rho_exactly(s, alpha);
}
// The float nearest to rho, in integers.
template <int N>
ALPHASCOPE_DEVICE_CALL float exact_rounded_rho(const LiftedSimplex<N>& s) {
  return round_exact(exact_rho(s));
}
// The float nearest to rho: the alpha value of an unattached simplex.
template <int N>
ALPHASCOPE_HOST_DEVICE float rounded_rho(const LiftedSimplex<N>& s) {
  float rounded = 0;
  return round_bracket(rho_bracket(s, within_bracket_limit(s)), &rounded) ? rounded
                                                                          : exact_rounded_rho(s);
}

}  // namespace alphascope
