// SPDX-License-Identifier: GPL-3.0-or-later
// Ortho-radii as fractions of wide integers: comparison with alpha and with each other, and
// rounding to float. Host and device; notation of lifted.hpp.
#pragma once

#include <cmath>

#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/lifted.hpp"
#include "core/predicates/rounding.hpp"
#include "core/predicates/wide_int.hpp"

namespace alphascope {

// The exact ortho-radius as a fraction: rho = numerator / denominator, denominator > 0. 256 bits
// hold every one. Edge: c² < 2^126 and 4 |d|² < 2^64. Triangle: |n| < 2^61 in every direction, 4 n²
// < 2^126, |v| < 2^94. Tetrahedron: |N| < 2^126, P < 2^254, |D| < 2^93. Weights: w < 2^52.
struct ExactRho {
  WideInt<4> numerator, denominator;
};

ALPHASCOPE_HOST_DEVICE inline ExactRho quotient_minus_weight(const WideInt<4>& p,
                                                             const WideInt<4>& q,
                                                             std::int64_t weight) {
  return {p - q.times(weight), q};
}
ALPHASCOPE_HOST_DEVICE inline WideInt<4> square_of(const Vector3<Int128>& v) {
  return square_of(v.x) + square_of(v.y) + square_of(v.z);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_vertex_rho(std::int64_t weight) {
  return quotient_minus_weight(WideInt<4>(0), WideInt<4>(1), weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_edge_rho(const LiftedInt& j, std::int64_t weight) {
  return quotient_minus_weight(square_of(Int128{j.c}), WideInt<4>(dot(j, j)).times(4), weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_triangle_rho(const LiftedInt& j, const LiftedInt& k,
                                                          std::int64_t weight) {
  const Vector3<std::int64_t> n = cross(j, k);
  const auto combined = [&](std::int64_t a, std::int64_t b) {
    return Int128{j.c} * b - Int128{k.c} * a;
  };
  return quotient_minus_weight(
      square_of({combined(j.x, k.x), combined(j.y, k.y), combined(j.z, k.z)}),
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
  return quotient_minus_weight(square_of({combined(kl.x, lj.x, jk.x), combined(kl.y, lj.y, jk.y),
                                          combined(kl.z, lj.z, jk.z)}),
                               square_of(2 * d), weight);
}

// rho of a simplex of any dimension; its balls must be affinely independent.
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_rho(const LiftedSimplex<1>& s) {
  return exact_vertex_rho(s.weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_rho(const LiftedSimplex<2>& s) {
  return exact_edge_rho(s.v[0], s.weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_rho(const LiftedSimplex<3>& s) {
  return exact_triangle_rho(s.v[0], s.v[1], s.weight);
}
ALPHASCOPE_HOST_DEVICE inline ExactRho exact_rho(const LiftedSimplex<4>& s) {
  return exact_tetrahedron_rho(s.v[0], s.v[1], s.v[2], s.weight);
}

// Sign of rho - value. The value is any finite double that is a multiple of 2^-160.
ALPHASCOPE_HOST_DEVICE int compare_exact(const ExactRho& rho, double value);

// Sign of rho - alpha. An alpha that is no double is n / 10^18. With rho = p / q, the two sides are
// 10^18 p, of 60 + 255 bits, and n q, of 120 + 60 + 188 bits.
ALPHASCOPE_HOST_DEVICE inline int compare_exact(const ExactRho& rho, const LatticeAlpha& alpha) {
  if (alpha.is_double()) return compare_exact(rho, alpha.below);
  using Wide = WideInt<8>;
  static_assert(Alpha::kParts < std::int64_t{1} << 60 && 60 + 255 < 511 && 120 + 60 + 188 < 511);
  const Wide n = Wide::of(alpha.whole).times(Alpha::kParts) + Wide(alpha.fraction);
  return (Wide(rho.numerator).times(Alpha::kParts) - n * Wide(rho.denominator)).sign();
}

// Sign of a - b. Bits: 255 + 188.
ALPHASCOPE_HOST_DEVICE inline int compare_exact(const ExactRho& a, const ExactRho& b) {
  using Wide = WideInt<8>;
  return (Wide(a.numerator) * Wide(b.denominator) - Wide(b.numerator) * Wide(a.denominator)).sign();
}

// The float nearest to rho, halves to even; infinite beyond the largest float.
ALPHASCOPE_HOST_DEVICE float round_exact(const ExactRho& rho);

// ---- definitions of the two exact functions ----

ALPHASCOPE_HOST_DEVICE inline int compare_exact(const ExactRho& rho, double value) {
  // Since |rho| < 2^255, the sign of a larger value decides.
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
  // The slack is twice the error of the quotient. It is far smaller than half a float's spacing.
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
  // low and high are neighbouring floats. Their mean is a double, and comparing rho with it
  // decides.
  const double middle = 0.5 * (static_cast<double>(low) + static_cast<double>(high));
  const int side = compare_exact(rho, middle);
  if (side != 0) return side < 0 ? low : high;
  return static_cast<float>(middle);  // a tie: the double-to-float conversion rounds it to even
}

}  // namespace alphascope
