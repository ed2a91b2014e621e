// Counting sort of the balls into the cells of the grid.
#pragma once

#include "gpu/ball_wire.cuh"
#include "gpu/problem.cuh"

namespace alphascope::gpu {

__device__ inline int grid_cell(int coordinate, int lower, int width) {
  return (coordinate - lower) / width + 1;
}

// Balls [begin, end). They came packed, or as they are.
__global__ void assign_cells(Problem p, std::uint32_t begin, std::uint32_t end, PackedBalls packed,
                             int4* balls, std::uint32_t* cell_count, uint2* cell_and_rank) {
  const std::uint32_t i = begin + blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= end) return;
  const int4 b = packed.data != nullptr ? packed[i] : balls[i];
  if (packed.data != nullptr) balls[i] = b;
  const double square = static_cast<double>(static_cast<std::int64_t>(b.w) * b.w) + p.alpha;
  std::uint32_t cell = p.cell_count - 1;  // the dead: hidden (negative radius) or empty at alpha
  if (b.w > 0 && square >= 0) {
    cell = (grid_cell(b.x, p.origin.x, p.cell_width) * p.ny +
            grid_cell(b.y, p.origin.y, p.cell_width)) *
               p.nz +
           grid_cell(b.z, p.origin.z, p.cell_width);
  }
  cell_and_rank[i] = make_uint2(cell, atomicAdd(&cell_count[cell], 1u));
}

// BallHome::part, which needs no more than what it promises: quick.
__device__ inline std::uint32_t part_of_cell(const Problem& p, const int4& b) {
  const auto part = [&](int coordinate, int lower) {
    const float within = static_cast<float>((coordinate - lower) % p.cell_width);
    return static_cast<std::uint32_t>(min(static_cast<int>(within * p.fraction), kCellParts - 1));
  };
  return part(b.x, p.origin.x) | part(b.y, p.origin.y) << 10 | part(b.z, p.origin.z) << 20;
}

// What sort_into_cells() writes; as SortedBalls.
struct SortedBuffers {
  std::uint32_t* index;
  float4* near;
  BallHome* home;
};

__global__ void sort_into_cells(Problem p, const int4* balls, const uint2* cell_and_rank,
                                const std::uint32_t* cell_start, SortedBuffers to) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= p.ball_count) return;
  const int4 b = balls[i];
  const uint2 c = cell_and_rank[i];
  const std::uint32_t slot = cell_start[c.x] + c.y;
  to.index[slot] = i;
  const float square =
      static_cast<float>(static_cast<double>(static_cast<std::int64_t>(b.w) * b.w) + p.alpha);
  // 2^-16 is far above the roundings of the test of two balls.
  const float reach = sqrtf(fmaxf(square, 0.0f)) * (1.0f + 1.0f / 65536) + p.reach_slack;
  const auto dead = static_cast<std::uint32_t>(p.cell_count - 1);
  to.home[i] = c.x == dead
                   ? BallHome{slot, static_cast<std::uint32_t>((p.ny + 1) * p.nz + 1), 0, -1}
                   : BallHome{slot, c.x, part_of_cell(p, b), reach};
  const auto from_origin = [](int at, int origin) {
    return static_cast<float>(static_cast<std::int64_t>(at) - origin);
  };
  to.near[slot] = make_float4(from_origin(b.x, p.origin.x), from_origin(b.y, p.origin.y),
                              from_origin(b.z, p.origin.z), reach);
}

}  // namespace alphascope::gpu
