// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ball before each open face whose sphere is small, in a grid.
//
// A guessed sphere of the face contains the part before the face of every smaller one. So if a ball
// touches no later than the guess, the balls in the guessed sphere decide. Else a larger sphere is
// guessed, and the tree takes over at last.
#pragma once

#include "gpu/wrapping/near_grid.cuh"
#include "gpu/wrapping/tree_search.cuh"

namespace alphascope::gpu {

// The radius of a guess, in that of the face's smallest sphere or in SearchSpace's guess, whichever
// is larger. Each next guess is larger by a factor.
inline constexpr int kGuesses = 3;
inline constexpr float kFirstGuess = 1.5f, kNextGuess = 1.6f;
inline constexpr int kMostRows = 80;  // in the box of a guessed sphere

// Runs of balls in up to eight rows, numbered 0, 1, ...
struct RowRuns {
  std::uint32_t end[kFan], base[kFan];  // number after the last ball; place minus number

  __device__ std::uint32_t place(std::uint32_t number) const {
    int r = number >= end[3] ? 4 : 0;
    r += number >= end[r + 1] ? 2 : 0;
    r += number >= end[r] ? 1 : 0;
    return base[r] + number;
  }
};

// The cells of a sphere's box.
struct CellBox {
  int x0, y0, nx, ny;

  __device__ static int cell(const NearGrid& g, float at, int count) {
    return max(0, min(count - 1, static_cast<int>(floorf(at * g.inverse_width))));
  }
  __device__ void set(const NearGrid& g, const SearchRegion& of, float reach) {
    x0 = cell(g, of.x - reach, g.nx);
    y0 = cell(g, of.y - reach, g.ny);
    nx = cell(g, of.x + reach, g.nx) - x0 + 1;
    ny = cell(g, of.y + reach, g.ny) - y0 + 1;
  }
};

// The balls of a row that a region may contain: [begin, end) of the grid. Cells count as wider by
// `kCellMargin`, which is above the roundings of their sides.
inline constexpr float kCellMargin = 1.0f / 256;
__device__ inline uint2 balls_of_row(const NearGrid& g, const SearchRegion& of, int x, int y,
                                     float reach_square) {
  const float x0 = static_cast<float>(x) * g.scaled_width - kCellMargin,
              x1 = static_cast<float>(x + 1) * g.scaled_width + kCellMargin,
              y0 = static_cast<float>(y) * g.scaled_width - kCellMargin,
              y1 = static_cast<float>(y + 1) * g.scaled_width + kCellMargin;
  const float dx = fmaxf(fmaxf(x0 - of.x, of.x - x1), 0.0f),
              dy = fmaxf(fmaxf(y0 - of.y, of.y - y1), 0.0f);
  const float rest = reach_square - fmaf(dx, dx, dy * dy);
  if (!(rest >= 0)) return make_uint2(0, 0);
  const float dz = rough_square_root(rest + 1e-30f) * 1.00001f + kCellMargin;
  float low = of.z - dz, high = of.z + dz;
  const float ahead = fmaf(of.hx, of.hx > 0 ? x1 : x0, of.hy * (of.hy > 0 ? y1 : y0));
  const float needed = of.plane - ahead;  // <= hz z
  if (of.hz > 0) {
    low = fmaxf(low, needed * rough_reciprocal(of.hz) - kCellMargin);
  } else if (of.hz < 0) {
    high = fminf(high, needed * rough_reciprocal(of.hz) + kCellMargin);
  } else if (needed > 0) {
    return make_uint2(0, 0);
  }
  if (!(low <= high)) return make_uint2(0, 0);
  const int z0 = CellBox::cell(g, low, g.nz), z1 = CellBox::cell(g, high, g.nz);
  const std::uint32_t* row = g.start + (static_cast<std::size_t>(x) * g.ny + y) * g.nz;
  return make_uint2(row[z0], row[z1 + 1]);
}

// Faces that follow each other in the queue often belong to the same tetrahedron before them. They
// are searched in turns, so that the first finds it and claims it for the others.
inline constexpr std::uint32_t kTurns = 3;

// `guess`: least radius of the first guessed sphere, in scaled units. `far`: for faces whose
// spheres are too large.
__global__ void __launch_bounds__(kSearchThreads)
    search_near(Front front, SearchSpace space, NearGrid grid, float guess, std::uint32_t* next,
                SearchList far) {
  __shared__ RowRuns shared_runs[kSearchThreads / kFan];
  const std::uint32_t begin = front.counts->begin, count = front.counts->end - begin,
                      turn = (count + kTurns - 1) / kTurns;
  const BallTree& tree = space.tree;
  const int lane = static_cast<int>(threadIdx.x & 31), sub = lane % kFan, group = lane - sub;
  RowRuns& runs = shared_runs[threadIdx.x / kFan];
  const float scale = tree.scale;

  for (;;) {
    std::uint32_t taken = 0;
    if (lane == 0) taken = atomicAdd(next, 4u);
    taken = __shfl_sync(~0u, taken, 0);
    if (taken >= kTurns * turn) return;
    taken += static_cast<std::uint32_t>(group / kFan);
    const std::uint32_t at = taken % turn * kTurns + taken / turn;

    FaceSearch<float> search;
    BestBalls best;
    best.clear();
    bool active = taken < kTurns * turn && at < count, found = false;
    FaceRef ref = 0;
    if (active) {
      ref = front.queue[begin + at];
      active = front.faces.neighbours[ref] == kOpen && front.apex[ref] != kClaimed;
    }
    if (active && !search.set(face_of(front.faces.quads[ref >> 2], static_cast<int>(ref & 3)),
                              space.balls, tree)) {
      active = false;
      if (sub == 0) space.exact.add(ref);
    }
    float radius = 0, at_foot = 0;
    if (active) {
      const Vector3<float>& foot = search.face.line().foot();
      const float own = static_cast<float>(search.ball.w) * scale;
      at_foot = fmaf(foot.x, foot.x, fmaf(foot.y, foot.y, foot.z * foot.z)) - own * own;
      radius = kFirstGuess * fmaxf(guess, sqrtf(fmaxf(at_foot, 0.0f)));
    }
    const bool searches = active;
    for (int attempt = 0; attempt < kGuesses && __any_sync(~0u, active); ++attempt) {
      if (active) best.clear();  // another lane may see a ball again
      float t = 0, reach_square = 0;
      CellBox box{0, 0, 0, 0};
      if (active) {
        t = rough_square_root(fmaxf(radius * radius - at_foot, 1e-30f) *
                              rough_reciprocal(search.face.line().direction_square()));
        search.limit_to(t, tree, space.weight);
        reach_square = search.region.limit + space.weight;
        box.set(grid, search.region,
                rough_square_root(fmaxf(reach_square, 1e-30f)) * 1.00001f + kCellMargin);
        if (box.nx * box.ny > kMostRows) active = false;
      }
      const int rows = active ? box.nx * box.ny : 0;
      for (int row0 = 0; __any_sync(~0u, row0 < rows); row0 += kFan) {
        const int row = row0 + sub;
        uint2 run = make_uint2(0, 0);
        if (row < rows)
          run = balls_of_row(grid, search.region, box.x0 + row / box.ny, box.y0 + row % box.ny,
                             reach_square);
        const std::uint32_t length = run.y - run.x;
        std::uint32_t sum = length;
        for (int step = 1; step < kFan; step *= 2) {
          const std::uint32_t other = __shfl_up_sync(~0u, sum, step, kFan);
          if (sub >= step) sum += other;
        }
        runs.end[sub] = sum;
        runs.base[sub] = run.x - (sum - length);
        __syncwarp();
        const std::uint32_t all = runs.end[kFan - 1];
        for (std::uint32_t number = sub; __any_sync(~0u, number < all); number += kFan) {
          if (number >= all) continue;
          const std::uint32_t place = runs.place(number);
          const int4 b = grid.ball[place];
          const std::uint32_t slot = grid.slot[place];
          if (slot == search.balls.i || slot == search.balls.j || slot == search.balls.k) continue;
          best.add(search.crossing_of(b, scale), slot);
        }
        __syncwarp();
      }
      const float least = least_of_lanes(best.high);
      if (active && least <= t) {
        found = true;
        active = false;
      }
      radius *= kNextGuess;
    }
    if (searches && !found && sub == 0) far.add(ref);
    const std::uint32_t apex = end_search(front, space, found, ref, best);
    claim_others(front, search.balls, apex);
    __syncwarp();
  }
}

}  // namespace alphascope::gpu
