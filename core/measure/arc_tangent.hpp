// SPDX-License-Identifier: GPL-3.0-or-later
// The angle of a vector, with the same bits on CPU and device. Libraries differ in the last bits.
// Host and device, without fused operations.
#pragma once

#include <math.h>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// As atan2(y, x), within two units of the last place (tests/core/measure/arc_tangent_test.cpp
// compares with more bits; 1.6 was the most of ten million). The angle of the zero vector is 0.
// Sums of products of coordinates, squares and their roots are far from overflow and underflow.
//
// atan(t) = atan(k/8) + atan(u), where k/8 is the eighth next to t, and u = (t - k/8) / (1 + t k/8)
// is at most 1/16. The series of atan(u) ends at u^13; the next term is below 2^-60 of it.
ALPHASCOPE_INLINE double arc_tangent(double y, double x) {
  constexpr double kEighth[9] = {0,
                                 0.12435499454676144,
                                 0.24497866312686414,
                                 0.35877067027057225,
                                 0.4636476090008061,
                                 0.5585993153435624,
                                 0.6435011087932844,
                                 0.7188299996216245,
                                 0.7853981633974483};
  // What these lack of atan(k/8).
  constexpr double kRest[9] = {0,
                               -3.1253241424539383e-18,
                               1.0698755618734451e-17,
                               -2.4623815582638635e-17,
                               2.2698777452961687e-17,
                               -5.4556305485916264e-18,
                               1.5834785051444286e-17,
                               -2.1478388444456983e-17,
                               3.061616997868383e-17};
  constexpr double kHalfTurn = 3.141592653589793, kHalfTurnRest = 1.2246467991473532e-16;
  const double up = fabs(y), along = fabs(x);
  const bool steep = up > along;
  const double large = steep ? up : along, small = steep ? along : up;
  if (!(large > 0)) return 0;
  const int k = static_cast<int>(8 * (small / large) + 0.5);
  const double eighth = 0.125 * k;
  const double u = (small - eighth * large) / (large + eighth * small), v = u * u;
  const double series =
      v * (-1.0 / 3 + v * (1.0 / 5 + v * (-1.0 / 7 + v * (1.0 / 9 + v * (-1.0 / 11 + v / 13)))));
  double angle = kEighth[k] + (u + (u * series + kRest[k]));
  if (steep) angle = kHalfTurn / 2 - (angle - kHalfTurnRest / 2);
  if (x < 0) angle = kHalfTurn - (angle - kHalfTurnRest);
  return y < 0 ? -angle : angle;
}

}  // namespace alphascope
