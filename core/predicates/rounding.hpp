// SPDX-License-Identifier: GPL-3.0-or-later
// Unit roundoffs for certified error bounds, in single and double precision.
#pragma once

namespace alphascope {

inline constexpr double kUnitRoundoff = 1.1102230246251565e-16;  // 2^-53

// u with a margin of 3 %, which covers the roundings of the bounds themselves. The components d of
// lifted vectors are exact in either precision; c is rounded to the nearest number.
template <class Real>
struct Rounding;
template <>
struct Rounding<float> {
  static constexpr float u = 6.14e-8f;
};
template <>
struct Rounding<double> {
  static constexpr double u = 1.144e-16;
};

}  // namespace alphascope
