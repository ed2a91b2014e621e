// SPDX-License-Identifier: GPL-3.0-or-later
// The test whether two balls, each grown by alpha, may meet. Every neighbour search uses it, on
// host and device; core/neighbours/meeting_slots.cpp has it in vectors. It never misses a pair that
// meets; it may accept a pair that only just does not meet.
//
// The bound, with u = 2^-24. Centres are subtracted as integers, which are below 2^30, and then
// rounded: each difference errs by u. (On a device they may come otherwise:
// gpu/dual_edge/problem.cuh.) Their squares err by 3 u each, and the sum of three by 2 u more. So
// the left side is at most (1 + u)^5 |d|². Reaches exceed the grown radii by the factor 1 + 2^-18,
// less u. Their sum errs by u, its square by 2 u, and the rounding of the square by u. So the right
// side is at least (1 + 2^-18)² (1 - u)^5 times the square of the distance at which the balls
// touch. It is larger by a factor of 1 + 2^-17 - 10 u > 1 + 2^-18, whatever the units of the
// lattice. Coordinates are below 2^29, radii below 2^26, and alpha is any. (From 2^128 on the right
// side is infinite; the left side never is.)
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// The radius of a grown ball in lattice units, rounded up by the margin of the test. `square` is
// weight + alpha, and at least 0.
inline float grown_reach(double square) {
  constexpr double kMargin = 1.0 + 1.0 / (1 << 18);
  return static_cast<float>(std::sqrt(square) * kMargin);
}

// x, y, z is the vector from one centre to the other, in lattice units.
ALPHASCOPE_INLINE bool grown_balls_may_meet(float x, float y, float z, float reach,
                                            float other_reach) {
  const float sum = reach + other_reach;
#ifdef __CUDA_ARCH__
  return fmaf(x, x, fmaf(y, y, z * z)) <= sum * sum;
#else
  return x * x + y * y + z * z <= sum * sum;
#endif
}
ALPHASCOPE_INLINE bool grown_balls_may_meet(std::int32_t x, std::int32_t y, std::int32_t z,
                                            float reach, float other_reach) {
  return grown_balls_may_meet(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
                              reach, other_reach);
}

}  // namespace alphascope
