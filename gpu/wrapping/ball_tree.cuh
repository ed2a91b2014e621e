// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of boxes over balls on the device, with eight children a node. Eight lanes test the
// children of a node at once. Balls come in the order of a curve, so the nodes are implicit: node x
// of a level has children 8x to 8x + 7 of the level below, and leaf x has those balls.
#pragma once

#include <cuda_runtime.h>

#include <cmath>
#include <cstdint>

#include "gpu/memory/launch.cuh"

namespace alphascope::gpu {

inline constexpr int kFan = 8;
inline constexpr int kMaxTreeLevels = 8;  // for 8^8 balls
inline constexpr std::size_t kMaxTreeBalls = std::size_t{1} << 24;

// Boxes that contain the centres, from the tree's origin, in scaled units and rounded outwards.
struct TreeBoxes {
  float4* low;   // w: the largest weight in the box, rounded up
  float4* high;  // w: unused
};

struct BallTree {
  const int4* ball;                     // centre and radius, lattice units, in the tree's order
  const std::uint32_t* slot;            // of each ball in the tree
  TreeBoxes boxes;                      // of all levels
  std::uint32_t first[kMaxTreeLevels];  // of each level in `boxes`; level 0: the boxes of leaves
  std::uint32_t count[kMaxTreeLevels];
  std::uint32_t balls;
  int top;  // the level with one box
  int4 origin;
  float scale;  // power of two: scaled = lattice * scale
};

// Numbers of boxes of a tree.
inline std::uint32_t set_levels(BallTree& tree, std::uint32_t balls) {
  tree.balls = balls;
  std::uint32_t all = 0, count = balls;
  for (int level = 0; level < kMaxTreeLevels; ++level) {
    count = (count + kFan - 1) / kFan;
    tree.first[level] = all;
    tree.count[level] = count;
    tree.top = level;
    all += count;
    if (count <= 1) break;
  }
  return all;
}

__device__ inline std::uint32_t grid_thread() {
  return blockIdx.x * blockDim.x + threadIdx.x;
}

// A coordinate from the origin in scaled units, with an error of at most one rounding.
__device__ inline float scaled_offset(int coordinate, int origin, float scale) {
  return static_cast<float>(coordinate - origin) * scale;
}
inline constexpr float kOutwards = 1.0f + 1.0f / (1 << 22);  // above two roundings

// The bits of a coordinate, with two zeros after each.
__device__ inline std::uint64_t spread_bits(std::uint32_t value) {
  std::uint64_t v = value & 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffull;
  v = (v | v << 16) & 0x1f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  v = (v | v << 2) & 0x1249249249249249ull;
  return v;
}

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

struct BoxSum {
  float low[3] = {1e38f, 1e38f, 1e38f}, high[3] = {-1e38f, -1e38f, -1e38f}, weight = 0;

  __device__ void add(int axis, float from, float to) {
    low[axis] = fminf(low[axis], from);
    high[axis] = fmaxf(high[axis], to);
  }
  __device__ void put(const TreeBoxes& to, std::uint32_t at) const {
    to.low[at] = make_float4(low[0], low[1], low[2], weight);
    to.high[at] = make_float4(high[0], high[1], high[2], 0);
  }
};

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
