// SPDX-License-Identifier: GPL-3.0-or-later
// Balls in the cells of a grid, for searches in small spheres. A row is the cells of one x and y,
// whose balls follow each other.
#pragma once

#include "gpu/wrapping/ball_tree.cuh"

namespace alphascope::gpu {

struct NearGrid {
  int4* ball;
  std::uint32_t* slot;
  std::uint32_t* start;  // of each cell, and of the end
  std::uint32_t* cell;   // of each ball of the tree
  std::uint32_t* rank;   // of each ball of the tree within its cell
  int width;             // lattice units
  int nx, ny, nz;
  float scaled_width, inverse_width;

  __host__ __device__ std::uint32_t cells() const {
    return static_cast<std::uint32_t>(nx) * static_cast<std::uint32_t>(ny) *
           static_cast<std::uint32_t>(nz);
  }
};

// `grid.start` must be zero before. It has the number of balls of each cell after.
__global__ void count_cells(BallTree tree, NearGrid grid) {
  const std::uint32_t n = grid_thread();
  if (n >= tree.balls) return;
  const int4 b = tree.ball[n];
  const int x = (b.x - tree.origin.x) / grid.width, y = (b.y - tree.origin.y) / grid.width,
            z = (b.z - tree.origin.z) / grid.width;
  const auto cell = static_cast<std::uint32_t>((x * grid.ny + y) * grid.nz + z);
  grid.cell[n] = cell;
  grid.rank[n] = atomicAdd(&grid.start[cell], 1u);
}
__global__ void fill_cells(BallTree tree, NearGrid grid) {
  const std::uint32_t n = grid_thread();
  if (n >= tree.balls) return;
  const std::uint32_t at = grid.start[grid.cell[n]] + grid.rank[n];
  grid.ball[at] = tree.ball[n];
  grid.slot[at] = tree.slot[n];
}

}  // namespace alphascope::gpu
