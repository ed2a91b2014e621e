// SPDX-License-Identifier: GPL-3.0-or-later
// Ortho-radii of simplices as the nearest floats: the alpha values of unattached simplices.
#pragma once

#include "core/predicates/simplex_decisions.hpp"
#include "gpu/dual_edge/problem.cuh"

namespace alphascope::gpu {

// Launch bounds of kernels that compute values. Double precision waits for its operands, so more
// warps at once pay off. This holds even if registers spill.
constexpr int kValueThreads = 128, kValueBlocks = 6;

// A simplex as the templates of simplex_decisions.hpp need it: lifted from its first ball. The
// others are in slots 0 to 2.
struct SimplexBalls {
  int4 centre, other[3];

  __device__ LiftedInt lifted(int k) const {
    return lifted_vector(centre, centre.w, other[k], other[k].w);
  }
  __device__ std::int64_t weight() const { return static_cast<std::int64_t>(centre.w) * centre.w; }
};

template <class Decider>
__device__ inline Decision value_of(const SimplexBalls& balls, int vertices, float* value) {
  const LatticeAlpha unbounded(HUGE_VAL);
  const Neighbourhood<SimplexBalls> in{balls, balls.weight(), &unbounded, 0, true};
  return vertices == 2   ? decide_simplex<Decider>(in, value, 0)
         : vertices == 3 ? decide_simplex<Decider>(in, value, 0, 1)
                         : decide_simplex<Decider>(in, value, 0, 1, 2);
}
// Used if double precision does not tell which float is nearest, for about one simplex in a
// million.
__device__ inline __noinline__ float exact_value(const SimplexBalls& balls, int vertices) {
  float value = 0;
  value_of<ExactDecider>(balls, vertices, &value);
  return value;
}
template <int kVertices>
__device__ inline SimplexBalls simplex_balls(const int4* ball, const uint4& v) {
  return {ball[v.x], {ball[v.y], ball[kVertices > 2 ? v.z : v.y], ball[kVertices > 3 ? v.w : v.y]}};
}
// The ortho-radius of a simplex of K_alpha in square lattice units, as the nearest float.
template <int kVertices>
__device__ inline float ortho_radius(const SimplexBalls& balls) {
  float value = 0;
  if (value_of<FilteredDecider>(balls, kVertices, &value) == Decision::in) return value;
  return exact_value(balls, kVertices);
}

}  // namespace alphascope::gpu
