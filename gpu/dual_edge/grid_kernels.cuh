// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts the balls into the cells of the grid by counting.
#pragma once

#include "gpu/dual_edge/ball_wire.cuh"
#include "gpu/dual_edge/problem.cuh"

namespace alphascope::gpu {

// The cell along one axis, and the part of its width as in BallCell::part. The part is computed
// fast, with no more precision than BallCell promises.
struct CellOfAxis {
  std::uint32_t cell, part;

  __device__ CellOfAxis(const Problem& p, int coordinate, int lower) {
    const auto width = static_cast<std::uint32_t>(p.cell_width),
               from = static_cast<std::uint32_t>(coordinate) - static_cast<std::uint32_t>(lower),
               cells = from / width;
    cell = cells + 1;
    const auto within = static_cast<float>(static_cast<int>(from - cells * width));
    part = static_cast<std::uint32_t>(min(static_cast<int>(within * p.fraction), kCellParts - 1));
  }
};

// Output of assign_cells(): unpacked balls, the number of balls in each cell, and the homes of
// balls. A home has the ball's rank in its cell in place of its slot, which is not known yet.
struct CellBuffers {
  int4* balls;
  std::uint32_t* count;
  BallCell* home;
};

// Assigns the balls [begin, end), which came packed or unpacked.
__global__ void assign_cells(Problem p, std::uint32_t begin, std::uint32_t end, PackedBalls packed,
                             CellBuffers to) {
  const std::uint32_t i = begin + blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= end) return;
  const int4 b = packed.data != nullptr ? packed[i] : to.balls[i];
  if (packed.data != nullptr) to.balls[i] = b;
  const double square = p.alpha.plus(static_cast<std::int64_t>(b.w) * b.w);
  const CellOfAxis x(p, b.x, p.origin.x), y(p, b.y, p.origin.y), z(p, b.z, p.origin.z);
  // Dead balls are hidden (negative radius) or empty at alpha.
  const bool dead = b.w <= 0 || square < 0;
  const std::uint32_t cell = dead ? p.cell_count - 1 : (x.cell * p.ny + y.cell) * p.nz + z.cell;
  // grown_balls_may_meet() needs a margin above ten roundings; here it is 2^-16 less three. If
  // coordinates from the origin are not exact, both of a difference err by half of reach_slack in
  // each coordinate. Their distance then errs by at most sqrt(3) reach_slack, and two reaches
  // contain 2 reach_slack.
  const float reach =
      sqrtf(fmaxf(static_cast<float>(square), 0.0f)) * (1.0f + 1.0f / 65536) + p.reach_slack;
  to.home[i] = {atomicAdd(&to.count[cell], 1u), cell, x.part | y.part << 10 | z.part << 20, reach};
}

// Output of sort_into_cells(); as SortedBalls.
struct SortedBuffers {
  std::uint32_t* index;
  float4* near;
  BallCell* home;  // from assign_cells()
};

__global__ void sort_into_cells(Problem p, const int4* balls, const std::uint32_t* cell_start,
                                SortedBuffers to) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= p.ball_count) return;
  const int4 b = balls[i];
  const BallCell home = to.home[i];
  const std::uint32_t slot = cell_start[home.cell] + home.slot;
  to.index[slot] = i;
  if (home.cell == static_cast<std::uint32_t>(p.cell_count - 1)) {
    to.home[i] = {slot, static_cast<std::uint32_t>((p.ny + 1) * p.nz + 1), 0, -1};
  } else {
    to.home[i].slot = slot;
  }
  const auto from_origin = [](int at, int origin) {
    return static_cast<float>(static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(origin));
  };
  to.near[slot] = make_float4(from_origin(b.x, p.origin.x), from_origin(b.y, p.origin.y),
                              from_origin(b.z, p.origin.z), home.reach);
}

}  // namespace alphascope::gpu
