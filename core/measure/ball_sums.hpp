// How what simplices add to a ball is summed: as integer multiples of a unit that follows from its
// radius, so that neither order nor number of threads changes a bit. Host and device.
#pragma once

#include "core/geometry/host_device.hpp"
#include "core/measure/ball_geometry.hpp"
#include "core/measure/exact_sum.hpp"

namespace alphascope {

// One term is below 2^these, in units of R², R³ and R: no angle is above 2 pi, no length above 2 R.
inline constexpr int kAreaBits = 6, kVolumeBits = 5, kLengthBits = 7, kWallBits = 5;

// Units per 1 of a ball's sums; 0 where nothing can be added.
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
// Of the sums that simplex_terms.hpp speaks of. Nothing is below zero but by rounding.
ALPHASCOPE_INLINE BallMeasures ball_measures(double grown_radius, bool is_open, double area_sum,
                                             double volume_sum) {
  const double area = is_open && area_sum > 0 ? area_sum : 0;
  const double volume = grown_radius * area / 3 + volume_sum;
  return {area, volume > 0 ? volume : 0};
}

}  // namespace alphascope
