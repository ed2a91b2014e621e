// What all kernels of one request share: the problem, the balls in cell order, the neighbour
// search.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/grown_balls.hpp"

namespace alphascope::gpu {

inline constexpr int kBlockThreads = 128;

inline constexpr int kMaxBallsPerBlock = 32;

// What all kernels know about the request; passed by value.
struct Problem {
  int ball_count;
  int4 origin;                 // of the grid (w unused), lattice units
  int cell_width, nx, ny, nz;  // cells, with a border of empty ones
  int cell_count;              // with one more for the dead
  float reach_slack;  // lattice units: what rounding the coordinates can take from a distance
  float fraction;     // lattice units to kCellParts-ths of a cell
  float reach_max;    // no BallHome's ball reaches farther, in those parts
  LatticeAlpha alpha;
  bool whole;                // all simplices with values, not tetrahedra alone
  float scale;               // power of two: scaled = lattice * scale
  std::int64_t ghost_reach;  // power of two above every sqrt(w + alpha), lattice units
  int balls_per_block;
  int sampled;          // every so many blocks count for BlockStatistics
  int search_capacity;  // balls that a search may find: they fit the block's memory
};

// A request goes through its balls in chunks, so that the simplices of one are on their way to the
// host while the next is worked on. For how many there is memory.
inline constexpr int kMaxChunks = 16;

// Simplices of each dimension.
struct Totals {
  std::uint32_t of[4];
};

// Balls [begin, end) of the BallSet.
struct Chunk {
  std::uint32_t begin, end;
  Totals* before;  // of all balls before; those up to the end of the chunk come next
};

// What a block's shared memory has room for.
struct BlockRoom {
  std::uint32_t search;     // balls that meet one ball
  std::uint32_t list;       // of those, left in its list
  std::uint32_t entries;    // neighbours of all the block's balls
  std::uint32_t rows;       // those of higher index than their ball
  std::uint32_t triangles;  // of three balls that meet
  std::uint32_t listed;     // of those, worth a look
  std::uint32_t probed;     // of those, not probed away
  std::uint32_t kept;       // of those, in K_alpha; of tetrahedra alone, with one in K_alpha
};

// Of so many values: their sum, and that of their squares.
struct Measured {
  std::uint64_t number, sum, squares;
};

// What a run of blocks met, from which the room of the next run follows.
struct BlockStatistics {
  // Of every so many blocks (Problem::sampled). Of a ball: balls that meet it, and those left in
  // its list; of a block: what there should have been room for, see BlockRoom.
  Measured found, list, entries, rows, triangles, listed, probed, kept;
  std::uint32_t most_found, longest_list;   // of one ball
  std::uint32_t most_triangles, most_kept;  // of one ball that kernel III looked at
  std::uint32_t deferred;                   // balls that found no room and went to kernel III
  std::uint32_t too_long;                   // of those, by their list alone
};

// Where in the grid a ball is: its slot in cell order and its cell. And where in the cell: in
// kCellParts-ths of its width, 10 bits each of x, y and z, rounded down (by a hundredth part at
// most wrong).
inline constexpr int kCellParts = 1024;
struct alignas(16) BallHome {
  std::uint32_t slot, cell, part;  // dead: some cell
  float reach;                     // as SortedBalls::near's; below 0: dead
  __host__ __device__ int part_of(int axis) const {
    return static_cast<int>(part >> (10 * axis)) & (kCellParts - 1);
  }
};

// Balls in cell order, the dead ones last.
struct SortedBalls {
  const std::uint32_t* index;  // in the BallSet
  // x, y, z from the grid's origin (nearest floats) and how far the ball reaches, from above by
  // more than grown_balls.hpp asks for: see assign_cells(). Lattice units.
  const float4* near;
  const std::uint32_t* cell_start;
  const BallHome* home;  // in the order of the BallSet
};

// Lanes that look for the neighbours of one ball.
inline constexpr int kSearchLanes = 16;

// The balls of the cells around a ball that it can reach, numbered 0, 1, ...: nine rows of up to
// three cells, each a run of slots. For half a warp, which keeps it in shared memory of its own.
struct Surroundings {
  std::uint32_t end[9];   // the numbers before the end of each row
  std::uint32_t base[9];  // slot less number, in each row

  // All lanes of a warp call it; `reach`: of the ball, lattice units.
  __device__ void load(const Problem& p, const SortedBalls& balls, const BallHome& home,
                       float reach) {
    const int lane = threadIdx.x & (kSearchLanes - 1), r = lane < 9 ? lane : 8;
    const int to_x = r / 3 - 1, to_y = r % 3 - 1, z = home.part_of(2);
    // Parts between the ball and the row, and the cells before and after in it.
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
  // How far at least the next cell in a direction is, for a ball in this part of its own.
  static __device__ int away(int part, int direction) {
    return direction == 0 ? 0 : direction < 0 ? part : kCellParts - 1 - part;
  }
};

// What a search writes: where it looks, and the indices of the balls that it finds, in no order.
struct SearchMemory {
  Surroundings& around;
  std::uint32_t* found;
};

// Kernel I for two balls of one warp, half a warp each: lists the balls that theirs meets. Returns
// the number of all, also of those that do not fit; 0 when not `active`.
__device__ inline int search_neighbours(const Problem& p, const SortedBalls& balls,
                                        const BallHome& home, bool active, const SearchMemory& to) {
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
