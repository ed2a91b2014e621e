// What all kernels of one request share: the problem, the balls in cell order, the neighbour
// search.
#pragma once

#include <cuda_runtime.h>

#include <cstdint>

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
  double alpha;       // square lattice units
  bool whole;         // all simplices with values, not tetrahedra alone
  float scale;        // power of two: scaled = lattice * scale
  std::int64_t ghost_reach;  // power of two above every sqrt(w + alpha), lattice units
  int balls_per_block;
  int search_capacity;  // balls that a search may find: they fit the block's memory
};

// What a block's shared memory has room for.
struct BlockRoom {
  std::uint32_t search;     // balls that meet one ball
  std::uint32_t list;       // of those, left in its list
  std::uint32_t entries;    // neighbours of all the block's balls
  std::uint32_t rows;       // those of higher index than their ball
  std::uint32_t triangles;  // of three balls that meet
  std::uint32_t kept;       // of those, in K_alpha; of tetrahedra alone, with one in K_alpha
};

// What a run of blocks met. Sums over every `kSampled`-th block, from which the room of the next
// run follows; maxima over all.
struct BlockStatistics {
  std::uint64_t balls, found, found_squares, entries, entry_squares, triangles;
  std::uint32_t most_found, longest_list;   // of one ball
  std::uint32_t most_triangles, most_kept;  // of one ball that kernel III looked at
  std::uint32_t deferred;                   // balls that found no room and went to kernel III
};

// Balls in cell order.
struct SortedBalls {
  const int4* ball;            // x, y, z, radius
  const std::uint32_t* index;  // in the BallSet
  // x, y, z from the grid's origin (nearest floats) and sqrt(w + alpha), rounded up so far that
  // grown balls that meet are found to meet in single precision; lattice units.
  const float4* near;
  const std::uint32_t* cell;
  const std::uint32_t* cell_start;
  const std::uint32_t* alive;  // one number: balls before the dead ones
};

// Lanes that look for the neighbours of one ball.
inline constexpr int kSearchLanes = 16;

// The balls of the 27 cells around a ball, numbered 0, 1, ...: nine rows of three cells, each a run
// of slots. For half a warp, which keeps it in shared memory of its own.
struct Surroundings {
  std::uint32_t end[9];   // the numbers before the end of each row
  std::uint32_t base[9];  // slot less number, in each row

  // All lanes of a warp call it.
  __device__ void load(const Problem& p, const SortedBalls& balls, std::uint32_t slot) {
    const int lane = threadIdx.x & (kSearchLanes - 1), r = lane < 9 ? lane : 8;
    const std::uint32_t* row =
        balls.cell_start + balls.cell[slot] + ((r / 3 - 1) * p.ny + r % 3 - 1) * p.nz;
    const std::uint32_t begin = row[-1], length = row[2] - begin;
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
};

// Kernel I for two balls of one warp, half a warp each: lists the balls that theirs meets in
// `found`, in no order. Returns the number of all, also of those that do not fit; 0 when not
// `active`.
__device__ inline int search_neighbours(const Problem& p, const SortedBalls& balls,
                                        std::uint32_t slot, bool active, Surroundings& around,
                                        std::uint32_t* found) {
  const int lane = threadIdx.x & (kSearchLanes - 1), half = threadIdx.x & kSearchLanes;
  const float4 b = balls.near[slot];
  around.load(p, balls, slot);
  const std::uint32_t all = active ? around.end[8] : 0;
  int count = 0;
  for (std::uint32_t number = lane; __any_sync(~0u, number < all); number += kSearchLanes) {
    std::uint32_t t = slot;
    bool hit = false;
    if (number < all) {
      t = around.slot(number);
      const float4 o = balls.near[t];
      const float x = o.x - b.x, y = o.y - b.y, z = o.z - b.z, sum = o.w + b.w;
      hit = fmaf(x, x, fmaf(y, y, z * z)) <= sum * sum && t != slot;
    }
    const unsigned hits = __ballot_sync(~0u, hit) >> half & 0xffffu;
    const int at = count + __popc(hits & ((1u << lane) - 1));
    if (hit && at < p.search_capacity) found[at] = t;
    count += __popc(hits);
  }
  __syncwarp();
  return count;
}

}  // namespace alphascope::gpu
