// The sums of the terms that simplices add to a ball: integer multiples of a unit that follows from
// its radius. So neither the order nor the number of threads changes a bit. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/exact_sum.hpp"

namespace alphascope {

// Each term is below 2 to the power of these, in units of R² (area), R³ (volume), R (length) and R²
// (wall). No angle is above 2 pi, and no length above 2 R.
inline constexpr int kAreaBits = 6, kVolumeBits = 5, kLengthBits = 7, kWallBits = 5;

// Units per 1 of a ball's sums; 0 for an empty ball, to which no term is added.
ALPHASCOPE_INLINE double area_scale(const GrownBall& ball) {
  return ball.grown_radius > 0 ? fixed_scale(2 * bits_above(ball.grown_radius) + kAreaBits) : 0;
}
ALPHASCOPE_INLINE double volume_scale(const GrownBall& ball) {
  return ball.grown_radius > 0 ? fixed_scale(3 * bits_above(ball.grown_radius) + kVolumeBits) : 0;
}
ALPHASCOPE_INLINE double sum_value(FixedSum sum, double scale) {
  return scale == 0 ? 0 : fixed_value(sum, scale);
}

struct BallMeasures {
  double area, volume;  // lattice units
};
// Area and volume from the sums of simplex_terms.hpp. A negative sum can only come from rounding,
// so it counts as 0.
ALPHASCOPE_INLINE BallMeasures ball_measures(double grown_radius, bool is_open, double area_sum,
                                             double volume_sum) {
  const double area = is_open && area_sum > 0 ? area_sum : 0;
  const double volume = grown_radius * area / 3 + volume_sum;
  return {area, volume > 0 ? volume : 0};
}

}  // namespace alphascope
