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

}  // namespace alphascope::gpu
