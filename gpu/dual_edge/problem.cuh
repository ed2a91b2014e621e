// SPDX-License-Identifier: GPL-3.0-or-later
// Data and code that all kernels of a request share: the problem, the balls in cell order, the
// neighbour search.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/grown_balls.hpp"

namespace alphascope::gpu {

inline constexpr int kBlockThreads = 128;

inline constexpr int kMaxBallsPerBlock = 32;

// The request as all kernels need it; passed by value.
struct Problem {
  int ball_count;
  int4 origin;                 // origin of the grid (w unused), lattice units
  int cell_width, nx, ny, nz;  // cells, including a border of empty ones
  int cell_count;              // including one for dead balls
  float reach_slack;           // lattice units: largest error of a distance by rounded coordinates
  float fraction;              // factor from lattice units to kCellParts-ths of a cell
  float reach_max;             // largest reach of a ball, in those parts
  LatticeAlpha alpha;
  bool whole;                // true: all simplices with values; false: tetrahedra alone
  float scale;               // power of two: scaled = lattice * scale
  std::int64_t ghost_reach;  // power of two above every sqrt(w + alpha), lattice units
  int balls_per_block;
  int sampled;          // BlockStatistics are measured on one of this many blocks
  int search_capacity;  // balls that a search may find, limited by the block's memory
};

// The largest number of chunks of balls in a request; counters and events are reserved for these.
// The simplices of a chunk go to the host while the next chunk is computed.
inline constexpr int kMaxChunks = 16;

// Numbers of simplices by dimension.
struct Totals {
  std::uint32_t of[4];
};

// Balls [begin, end) of the BallSet.
struct Chunk {
  std::uint32_t begin, end;
  Totals* before;  // totals before the chunk; the next element has those after it
};

// Numbers for which a block's shared memory has room.
struct BlockRoom {
  std::uint32_t search;     // balls that meet one ball
  std::uint32_t list;       // of those, left in its list
  std::uint32_t entries;    // neighbours of all the block's balls
  std::uint32_t rows;       // neighbours of higher index than their ball
  std::uint32_t triangles;  // triangles of three balls that meet
  std::uint32_t listed;     // of those, candidates
  std::uint32_t probed;     // of those, kept by probing
  std::uint32_t kept;       // of those, in K_alpha; for tetrahedra alone, those with one in K_alpha
};

// A number of values with their sum and sum of squares.
struct Measured {
  std::uint64_t number, sum, squares;
};

// Sizes that the blocks of a run met. The room of the next run follows from them.
struct BlockStatistics {
  // Measured on sampled blocks (Problem::sampled). `found` and `list` are per ball: the balls that
  // meet it, and those left in its list. The others: per block, the numbers of BlockRoom that it
  // needed.
  Measured found, list, entries, rows, triangles, listed, probed, kept;
  std::uint32_t most_found, longest_list;   // largest values for one ball
  std::uint32_t most_triangles, most_kept;  // largest values for one ball in kernel III
  std::uint32_t deferred;  // number of balls that found no room and went to kernel III
  std::uint32_t too_long;  // number of those with too long a list
};

// The place of a ball in the grid: its slot in cell order, its cell, and its part there. The part
// is in kCellParts-ths of the cell's width, 10 bits each for x, y and z. It is rounded down, with
// an error of at most a hundredth part.
inline constexpr int kCellParts = 1024;
struct alignas(16) BallCell {
  std::uint32_t slot, cell, part;  // for dead balls: any cell
  float reach;                     // as in SortedBalls::near; below 0: dead
  __host__ __device__ int part_of(int axis) const {
    return static_cast<int>(part >> (10 * axis)) & (kCellParts - 1);
  }
};

// Balls in cell order, the dead ones last.
struct SortedBalls {
  const std::uint32_t* index;  // in the BallSet
  // x, y, z from the grid's origin (nearest floats) and how far the ball reaches, in lattice units.
  // The reach is rounded up by more than grown_balls.hpp needs: see assign_cells().
  const float4* near;
  const std::uint32_t* cell_start;
  const BallCell* home;  // in the order of the BallSet
};

// Number of lanes that search the neighbours of one ball.
inline constexpr int kSearchLanes = 16;

// The balls in the cells that a ball can reach, numbered 0, 1, ... They are in nine rows of up to
// three cells, each a run of slots. A half warp keeps it in its own shared memory.
struct ReachableBalls {
  std::uint32_t end[9];   // for each row the number after its last ball
  std::uint32_t base[9];  // for each row slot minus number

  // All lanes of a warp must call it. `reach`: of the ball, lattice units.
  __device__ void load(const Problem& p, const SortedBalls& balls, const BallCell& home,
                       float reach) {
    const int lane = threadIdx.x & (kSearchLanes - 1), r = lane < 9 ? lane : 8;
    const int to_x = r / 3 - 1, to_y = r % 3 - 1, z = home.part_of(2);
    // Distances in parts from the ball to the row, and within it to the cells before and after.
    const int x = away(home.part_of(0), to_x), y = away(home.part_of(1), to_y);
    const int before = x * x + y * y, first = away(z, -1), last = away(z, 1);
    const float most = fmaf(reach, p.fraction, p.reach_max), square = most * most;
    const auto reaches = [&](int parts) { return static_cast<float>(parts) <= square; };
    const std::uint32_t* row = balls.cell_start + home.cell + (to_x * p.ny + to_y) * p.nz;
    const std::uint32_t begin = row[reaches(before + first * first) ? -1 : 0];
    const std::uint32_t length =
        reaches(before) ? row[reaches(before + last * last) ? 2 : 1] - begin : 0;
    std::uint32_t sum = length;
#pragma unroll
    for (int step = 1; step < 9; step *= 2) {
      const std::uint32_t other = __shfl_up_sync(~0u, sum, step, kSearchLanes);
      if (lane >= step) sum += other;
    }
    if (lane < 9) {
      end[lane] = sum;
      base[lane] = begin - (sum - length);
    }
    __syncwarp();
  }
  __device__ std::uint32_t slot(std::uint32_t number) const {
    int r = number >= end[4] ? 5 : 0;
    r += number >= end[r + 1] ? 2 : 0;
    r += number >= end[r] ? 1 : 0;
    r += r < 8 && number >= end[r] ? 1 : 0;
    return base[r] + number;
  }

 private:
  // A lower bound of the distance to the next cell in a direction. `part` is the ball's part in its
  // own cell.
  static __device__ int away(int part, int direction) {
    return direction == 0 ? 0 : direction < 0 ? part : kCellParts - 1 - part;
  }
};

// Output of a search: the cells searched, and the indices of the balls found, in no order.
struct SearchMemory {
  ReachableBalls& around;
  std::uint32_t* found;
};

// Kernel I for two balls of one warp, half a warp for each: lists the balls that theirs meets.
// Returns the number of all, including those that do not fit; 0 if not `active`.
__device__ inline int search_neighbours(const Problem& p, const SortedBalls& balls,
                                        const BallCell& home, bool active, const SearchMemory& to) {
  const int lane = threadIdx.x & (kSearchLanes - 1), half = threadIdx.x & kSearchLanes;
  const std::uint32_t slot = home.slot;
  const float4 b = balls.near[slot];
  to.around.load(p, balls, home, b.w);
  const std::uint32_t all = active ? to.around.end[8] : 0;
  int count = 0;
  for (std::uint32_t number = lane; __any_sync(~0u, number < all); number += kSearchLanes) {
    std::uint32_t t = slot;
    bool hit = false;
    if (number < all) {
      t = to.around.slot(number);
      const float4 o = balls.near[t];
      hit = grown_balls_may_meet(o.x - b.x, o.y - b.y, o.z - b.z, b.w, o.w) && t != slot;
    }
    const unsigned hits = __ballot_sync(~0u, hit) >> half & 0xffffu;
    const int at = count + __popc(hits & ((1u << lane) - 1));
    if (hit && at < p.search_capacity) to.found[at] = balls.index[t];
    count += __popc(hits);
  }
  __syncwarp();
  return count;
}

}  // namespace alphascope::gpu
