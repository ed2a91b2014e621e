// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels that put balls in order and grow their tree.
#pragma once

#include "gpu/wrapping/ball_tree.cuh"

namespace alphascope::gpu {

// The place of each ball on Morton's curve over cells of 2^shift units.
__global__ void find_codes(const int4* balls, std::uint32_t count, int4 origin, int shift,
                           std::uint64_t* code, std::uint32_t* index) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  const int4 b = balls[n];
  code[n] = spread_bits(static_cast<std::uint32_t>(b.x - origin.x) >> shift) << 2 |
            spread_bits(static_cast<std::uint32_t>(b.y - origin.y) >> shift) << 1 |
            spread_bits(static_cast<std::uint32_t>(b.z - origin.z) >> shift);
  index[n] = n;
}

__global__ void gather_balls(const int4* balls, const std::uint32_t* index, std::uint32_t count,
                             int4* gathered, std::uint32_t* place) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  gathered[n] = balls[index[n]];
  place[index[n]] = n;
}

// Writes each ball to its index. One that another with the same centre hides gets the radius -1:
// the largest stays, and of equal ones the one with the lowest slot. Balls with the same centre
// have the same code. `most`: of the balls with one code that are looked at; more set *too_many.
__global__ void find_shown(const int4* balls, const std::uint64_t* code, const std::uint32_t* index,
                           std::uint32_t count, std::uint32_t most, int4* shown,
                           std::uint32_t* too_many) {
  const std::uint32_t n = grid_thread();
  if (n >= count) return;
  int4 own = balls[n];
  bool hidden = false;
  const auto look = [&](std::uint32_t m) {
    const int4 b = balls[m];
    const bool same = b.x == own.x && b.y == own.y && b.z == own.z;
    hidden = hidden || (same && (b.w > own.w || (b.w == own.w && m < n)));
  };
  std::uint32_t looked = 0;
  for (std::uint32_t m = n; m > 0 && looked < most && code[m - 1] == code[n]; --m, ++looked)
    look(m - 1);
  for (std::uint32_t m = n + 1; m < count && looked < most && code[m] == code[n]; ++m, ++looked)
    look(m);
  if (looked >= most) *too_many = 1;
  if (hidden) own.w = -1;
  shown[index[n]] = own;
}

// For evenly spread samples of the balls in that order: the distance to the nearest of the balls
// that follow. Balls at the same centre do not count.
__global__ void find_gaps(const int4* balls, std::uint32_t count, std::uint32_t samples,
                          float* gaps) {
  const std::uint32_t n = grid_thread();
  if (n >= samples) return;
  constexpr std::uint32_t kFollowing = 16;
  const auto from = static_cast<std::uint32_t>(std::uint64_t{n} * count / samples);
  const int4 own = balls[from];
  float least = 1e30f;
  for (std::uint32_t m = from + 1; m < count && m <= from + kFollowing; ++m) {
    const auto x = static_cast<float>(balls[m].x - own.x),
               y = static_cast<float>(balls[m].y - own.y),
               z = static_cast<float>(balls[m].z - own.z);
    const float square = fmaf(x, x, fmaf(y, y, z * z));
    if (square > 0) least = fminf(least, square);
  }
  gaps[n] = sqrtf(least);
}

__global__ void box_leaves(BallTree tree) {
  const std::uint32_t n = grid_thread();
  if (n >= tree.count[0]) return;
  BoxSum box;
  const std::uint32_t end = min((n + 1) * kFan, tree.balls);
  for (std::uint32_t m = n * kFan; m < end; ++m) {
    const int4 b = tree.ball[m];
    const float at[3] = {scaled_offset(b.x, tree.origin.x, tree.scale),
                         scaled_offset(b.y, tree.origin.y, tree.scale),
                         scaled_offset(b.z, tree.origin.z, tree.scale)};
    // The offset is not below 0.
    for (int axis = 0; axis < 3; ++axis)
      box.add(axis, at[axis] * (2 - kOutwards), at[axis] * kOutwards);
    const float radius = static_cast<float>(b.w) * tree.scale * kOutwards;
    box.weight = fmaxf(box.weight, radius * radius * kOutwards);
  }
  box.put(tree.boxes, n);
}

__global__ void box_level(BallTree tree, int level) {
  const std::uint32_t n = grid_thread();
  if (n >= tree.count[level]) return;
  BoxSum box;
  const std::uint32_t below = tree.first[level - 1];
  const std::uint32_t end = min((n + 1) * kFan, tree.count[level - 1]);
  for (std::uint32_t m = n * kFan; m < end; ++m) {
    const float4 low = tree.boxes.low[below + m], high = tree.boxes.high[below + m];
    box.add(0, low.x, high.x);
    box.add(1, low.y, high.y);
    box.add(2, low.z, high.z);
    box.weight = fmaxf(box.weight, low.w);
  }
  box.put(tree.boxes, tree.first[level] + n);
}

}  // namespace alphascope::gpu
