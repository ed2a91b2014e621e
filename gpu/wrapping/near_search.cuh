// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ball before each open face whose sphere is small, in a grid.
//
// A guessed sphere of the face contains the part before the face of every smaller one. So if a ball
// touches no later than the guess, the balls in the guessed sphere decide. Else a larger sphere is
// guessed, and the tree takes over at last.
#pragma once

#include "gpu/wrapping/hidden.cuh"
#include "gpu/wrapping/near_grid.cuh"
#include "gpu/wrapping/tree_search.cuh"

namespace alphascope::gpu {

// The radius of the first guess, in the largest of three: that of the face's smallest sphere, that
// of the known sphere behind the face if its centre is before the face, and the least that
// search_near() is given. Each next guess is larger by a factor.
inline constexpr int kGuesses = 3;
inline constexpr float kFirstGuess = 1.4f, kNextGuess = 1.6f;
inline constexpr float kLargestGuess = 4;  // in the least radius; the tree has larger spheres
inline constexpr int kMostRows = 80;       // in the box of a guessed sphere
inline constexpr int kListedBalls = 128;   // that wait until they are tried

// The cells of a sphere's box.
struct CellBox {
  int x0, y0, nx, ny;

  // row / ny, exact for up to kMostRows rows.
  __device__ int column(int row) const { return row * ((1 << 16) / max(ny, 1) + 1) >> 16; }
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

// The faces that a warp takes at once from the queue. Those that are claimed are passed over.
struct FaceChunk {
  FaceRef own = 0;    // of this lane
  unsigned left = 0;  // lanes whose face is still to be searched
  bool more = true;   // whether the queue may have others

  __device__ void take(const Front& front, std::uint32_t begin, std::uint32_t count,
                       std::uint32_t size, std::uint32_t* next) {
    const std::uint32_t turn = (count + kTurns - 1) / kTurns;
    const std::uint32_t lane = threadIdx.x & 31;
    while (left == 0 && more) {
      std::uint32_t taken = 0;
      if (lane == 0) taken = atomicAdd(next, size);
      taken = __shfl_sync(~0u, taken, 0);
      more = taken < kTurns * turn;
      taken += lane;
      const std::uint32_t at = taken % turn * kTurns + taken / turn;
      bool open = more && lane < size && taken < kTurns * turn && at < count;
      if (open) {
        own = front.queue[begin + at];
        open = front.faces.neighbours[own] == kOpen && __ldcg(&front.apex[own]) != kClaimed;
      }
      left = __ballot_sync(~0u, open);
    }
  }
  // The lane whose face the eight lanes of `group` shall take, or -1. `idle`: all lanes that want
  // one.
  __device__ int give(unsigned idle, int group) {
    int lane = -1;
    for (int g = 0; g < 32; g += kFan) {
      if ((idle >> g & 1) == 0 || left == 0) continue;
      if (g == group) lane = __ffs(static_cast<int>(left)) - 1;
      left &= left - 1;
    }
    return lane;
  }
};

// `guess`: least radius for the first guess, in scaled units. `far`: for faces whose spheres are
// too large; some ball touches at each one's far_bounds or before. `kSmall`: see real_of().
template <bool kSmall>
__global__ void __launch_bounds__(kSearchThreads, kSearchBlocks)
    search_near(Front front, SearchSpace space, NearGrid grid, float guess, std::uint32_t* next,
                SearchList far, float* far_bounds) {
  __shared__ std::uint32_t shared_lists[kSearchThreads / kFan][kListedBalls];  // places in the grid
  const std::uint32_t begin = front.counts->begin, count = front.counts->end - begin;
  if (count == 0) return;
  const BallTree& tree = space.tree;
  const int lane = static_cast<int>(threadIdx.x & 31), sub = lane % kFan, group = lane - sub;
  std::uint32_t* const list = shared_lists[threadIdx.x / kFan];
  const float scale = tree.scale;
  const std::uint32_t warps = gridDim.x * (kSearchThreads / 32),
                      size = max(4u, min(32u, count / warps));

  FaceChunk chunk;
  FaceSearch<float> search;
  BestBalls best;
  bool active = false;
  int attempt = 0;
  float radius = 0, at_foot = 0, bound = 0;
  FaceRef ref = 0;
  for (;;) {
    chunk.take(front, begin, count, size, next);
    const int from = chunk.give(__ballot_sync(~0u, !active), group);
    const FaceRef given = __shfl_sync(~0u, chunk.own, from & 31);
    // One lane reads what others may change, since its eight lanes must agree.
    bool claimed = false;
    if (from >= 0 && sub == 0) claimed = __ldcg(&front.apex[given]) == kClaimed;
    claimed = __shfl_sync(~0u, claimed, group);
    if (from >= 0) {
      ref = given;
      active = !claimed;
      attempt = 0;
      bound = Crossing<float>::kNever;
      const Quad quad = front.faces.quads[ref >> 2];
      const int corner = static_cast<int>(ref & 3);
      if (!search.set(face_of(quad, corner), space.balls, tree)) {
        if (active && sub == 0) space.exact.add(ref);
        active = false;
      }
      const Vector3<float>& foot = search.face.line().foot();
      const float own = static_cast<float>(search.ball.w) * scale;
      at_foot = fmaf(foot.x, foot.x, fmaf(foot.y, foot.y, foot.z * foot.z)) - own * own;
      const float behind =
          search.template radius_with<kSmall>(space.balls[ball_at(quad, corner)], scale, at_foot);
      radius = kFirstGuess * fmaxf(fmaxf(guess, behind), sqrtf(fmaxf(at_foot, 0.0f)));
    }
    if (!__any_sync(~0u, active)) {
      if (chunk.left == 0 && !chunk.more) return;
      continue;
    }

    best.clear();  // another lane may see a ball again
    float t = 0, reach_square = 0;
    CellBox box{0, 0, 0, 0};
    int rows = 0;
    bool too_large = radius > kLargestGuess * guess;
    if (active && !too_large) {
      t = rough_square_root(fmaxf(radius * radius - at_foot, 1e-30f) *
                            rough_reciprocal(search.face.line().direction_square()));
      search.limit_to(t, tree, space.weight);
      reach_square = search.region.limit + space.weight;
      box.set(grid, search.region,
              rough_square_root(fmaxf(reach_square, 1e-30f)) * 1.00001f + kCellMargin);
      too_large = box.nx * box.ny > kMostRows;
      rows = too_large ? 0 : box.nx * box.ny;
    }
    const auto try_balls = [&](int all) {
      __syncwarp();
      for (int n = sub; __any_sync(~0u, n < all); n += kFan) {
        if (n >= all) continue;
        const int4 b = grid.ball[list[n]];
        const std::uint32_t slot = grid.slot[list[n]];
        if (slot == search.balls.i || slot == search.balls.j || slot == search.balls.k) continue;
        best.add(search.template crossing_of<kSmall>(b, scale), slot);
      }
      __syncwarp();
    };
    int listed = 0;
    for (int row0 = 0; __any_sync(~0u, row0 < rows); row0 += kFan) {
      const int row = row0 + sub;
      uint2 run = make_uint2(0, 0);
      if (row < rows) {
        const int column = box.column(row);
        run = balls_of_row(grid, search.region, box.x0 + column, box.y0 + row - column * box.ny,
                           reach_square);
      }
      const int length = static_cast<int>(run.y - run.x);
      int sum = length;
      for (int step = 1; step < kFan; step *= 2) {
        const int other = __shfl_up_sync(~0u, sum, step, kFan);
        if (sub >= step) sum += other;
      }
      // The lane's balls begin at `first` of the list. When it is full, they go on after it.
      int first = listed + sum - length;
      listed += __shfl_sync(~0u, sum, group + kFan - 1);
      for (;;) {
        for (int n = max(0, -first); n < length && first + n < kListedBalls; ++n)
          list[first + n] = run.x + static_cast<std::uint32_t>(n);
        if (!__any_sync(~0u, listed > kListedBalls)) break;
        try_balls(min(listed, kListedBalls));
        first -= kListedBalls;
        listed = max(0, listed - kListedBalls);
      }
    }
    try_balls(listed);
    const float least = least_of_lanes(best.high);
    const bool found = active && !too_large && least <= t,
               fails = active && !found && (too_large || attempt + 1 == kGuesses);
    bound = fminf(bound, least);
    if (fails && sub == 0) far_bounds[far.add(ref)] = bound;
    radius *= kNextGuess;
    ++attempt;
    if (__any_sync(~0u, found)) {
      const std::uint32_t apex = end_search(front, space, found, ref, best);
      claim_others(front, search.balls, apex);
    }
    if (found || fails) active = false;
  }
}

}  // namespace alphascope::gpu
