// SPDX-License-Identifier: GPL-3.0-or-later
// The sums of the terms that simplices add to a ball: integer multiples of a unit that follows from
// its radius. So neither the order nor the number of threads changes a bit. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/exact_sum.hpp"
#include "core/measure/measured_quantity.hpp"

namespace alphascope {

// As term_bits(), for the sums of derivatives: in units of R (length) and R² (wall).
inline constexpr int kLengthBits = 7, kWallBits = 5;

// Units per 1 of a ball's sums; 0 for an empty ball, to which no term is added.
ALPHASCOPE_INLINE PerQuantity<double> quantity_scales(const GrownBall& ball) {
  PerQuantity<double> scales = {};
  if (!(ball.grown_radius > 0)) return scales;
  const int bits = bits_above(ball.grown_radius);
  each_quantity([&](MeasuredQuantity q) {
    scales[q] = fixed_scale(power_of_length(q) * bits + term_bits(q));
  });
  return scales;
}
ALPHASCOPE_INLINE double sum_value(FixedSum sum, double scale) {
  return scale == 0 ? 0 : fixed_value(sum, scale);
}

// The quantities of a ball, in lattice units, from the sums of simplex_terms.hpp. A negative sum
// can only come from rounding, so it counts as 0. A ball without an open side has no part of the
// surface.
ALPHASCOPE_INLINE PerQuantity<double> ball_measures(double grown_radius, bool is_open,
                                                    const PerQuantity<double>& sums) {
  PerQuantity<double> of = {};
  each_quantity([&](MeasuredQuantity q) { of[q] = is_open && sums[q] > 0 ? sums[q] : 0; });
  const double volume =
      grown_radius * of[MeasuredQuantity::area] / 3 + sums[MeasuredQuantity::volume];
  of[MeasuredQuantity::volume] = volume > 0 ? volume : 0;
  return of;
}
// Converts a quantity from lattice units to Å; `unit` is in Å.
ALPHASCOPE_INLINE double in_angstrom(MeasuredQuantity q, double value, double unit) {
  for (int n = 0; n < power_of_length(q); ++n) value *= unit;
  return value;
}

}  // namespace alphascope
