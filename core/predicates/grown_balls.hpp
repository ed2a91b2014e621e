// Can two balls meet, each grown by alpha? The one test of every neighbour search, on host and
// device: it may say yes of two that just do not meet, never no of two that do.
//
// The bound, with u = 2^-24. Centres are subtracted as integers, which are below 2^30, and then
// rounded: each difference errs by u. (A device may have them otherwise:
// gpu/dual_edge/problem.cuh.) Their squares err by three u each and the sum of three by two more,
// so the left side is at most (1 + u)^5 |d|². Reaches are above the grown radii by a 2^18th part
// less an u, their sum errs by u, its square by two and one more: the right side is at least (1 +
// 2^-18)² (1 - u)^5 times the square of the distance at which the balls touch. That is more by
// 2^-17 - 10 u > 2^-18, whatever the lattice's units: 2^29 of a coordinate, 2^26 of a radius, and
// any alpha (from 2^128 on the right side is infinite, the left side never).
#pragma once

#include <cmath>
#include <cstdint>

#include "core/geometry/host_device.hpp"

namespace alphascope {

// How far a ball reaches, lattice units: from above, by the margin that the test needs.
// `square` >= 0: weight + alpha.
inline float grown_reach(double square) {
  constexpr double kMargin = 1.0 + 1.0 / (1 << 18);
  return static_cast<float>(std::sqrt(square) * kMargin);
}

// x, y, z: from one centre to the other.
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
