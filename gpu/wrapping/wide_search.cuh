// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ball before a face whose sphere is so large that it meets thousands of boxes. A block
// searches the tree level by level.
#pragma once

#include "core/geometry/ordered_bits.hpp"
#include "gpu/wrapping/tree_search.cuh"

namespace alphascope::gpu {

inline constexpr int kWideThreads = 1024;

inline constexpr std::uint32_t kWideCandidates = 1024;
inline constexpr int kWideAttempts = 16;

// As ordered_bits() does for a float.
__device__ inline unsigned long long ordered_double(double value) {
  const auto bits = static_cast<unsigned long long>(__double_as_longlong(value));
  return (bits >> 63) != 0 ? ~bits : bits | 0x8000000000000000ull;
}

// `nodes`: 2 kWideNodes for each block. A face that meets more boxes than that, or has too many
// candidates, goes to search_tree<true>().
__global__ void __launch_bounds__(kWideThreads)
    search_widely(Front front, SearchSpace space, SearchTask task, std::uint32_t* nodes) {
  __shared__ std::uint32_t taken, counts[2], candidate_count;
  __shared__ std::uint32_t least;  // ordered_bits() of the least `high`
  __shared__ unsigned long long fine_least;
  __shared__ std::uint32_t slots[kWideCandidates], fine_slots[kWideCandidates];
  const BallTree& tree = space.tree;
  const std::uint32_t end = *task.count;
  std::uint32_t* const lists[2] = {nodes + std::size_t{2} * kWideNodes * blockIdx.x,
                                   nodes + (std::size_t{2} * blockIdx.x + 1) * kWideNodes};
  for (;;) {
    __syncthreads();
    if (threadIdx.x == 0) taken = atomicAdd(task.next, 1u);
    __syncthreads();
    if (taken >= end) return;
    const FaceRef ref = task.faces[taken];
    FaceSearch<float> search;
    // It was set before, so it can be.
    search.set(face_of(front.faces.quads[ref >> 2], static_cast<int>(ref & 3)), space.balls, tree);
    search.limit_to(task.bounds[taken], tree, space.weight);
    if (threadIdx.x == 0) least = ordered_bits(task.bounds[taken]);
    bool fits = false;
    int from = 0;
    std::uint32_t leaves = 0;
    const auto each_ball = [&](const auto& use) {
      for (std::uint32_t n = threadIdx.x; n < kFan * leaves; n += kWideThreads) {
        const std::uint32_t m = lists[from][n / kFan] * kFan + n % kFan;
        if (m >= tree.balls) continue;
        const std::uint32_t slot = tree.slot[m];
        if (slot == search.balls.i || slot == search.balls.j || slot == search.balls.k) continue;
        use(search.crossing_of(tree.ball[m], tree.scale), slot);
      }
    };
    // Nodes without room are left out. The balls of the others limit the region for the next
    // attempt.
    for (int attempt = 0; attempt < kWideAttempts && !fits; ++attempt) {
      __syncthreads();
      if (threadIdx.x == 0) {
        counts[0] = 1;
        candidate_count = 0;
        lists[0][0] = 0;  // the top
      }
      fits = true;
      from = 0;
      for (int level = tree.top; level > 0; --level, from = 1 - from) {
        __syncthreads();
        const std::uint32_t count = min(counts[from], kWideNodes);
        if (threadIdx.x == 0) counts[1 - from] = 0;
        __syncthreads();
        for (std::uint32_t n0 = 0; n0 < kFan * count; n0 += kWideThreads) {
          const std::uint32_t n = n0 + threadIdx.x;
          std::uint32_t child = 0;
          bool passes = false;
          if (n < kFan * count) {
            child = lists[from][n / kFan] * kFan + n % kFan;
            if (child < tree.count[level - 1]) {
              const std::uint32_t box = tree.first[level - 1] + child;
              passes = search.region.may_contain(tree.boxes.low[box], tree.boxes.high[box]);
            }
          }
          append(passes, child, lists[1 - from], kWideNodes, &counts[1 - from]);
        }
        __syncthreads();
        fits = fits && counts[1 - from] <= kWideNodes;
      }
      __syncthreads();
      leaves = min(counts[from], kWideNodes);
      each_ball([&](const Crossing<float>& c, std::uint32_t) {
        if (c.high < from_ordered_bits(least)) atomicMin(&least, ordered_bits(c.high));
      });
      __syncthreads();
      if (!fits) search.limit_to(from_ordered_bits(least), tree, space.weight);
    }
    if (fits) {
      const float high = from_ordered_bits(least);
      each_ball([&](const Crossing<float>& c, std::uint32_t slot) {
        if (c.none() || c.low > high) return;
        const std::uint32_t place = atomicAdd(&candidate_count, 1u);
        if (place < kWideCandidates) slots[place] = slot;
      });
      __syncthreads();
    }
    // Double precision leaves few of many candidates, and integers decide between the others.
    std::uint32_t few = candidate_count;
    const std::uint32_t* listed = slots;
    if (fits && few > kMostCandidates && few <= kWideCandidates) {
      FaceSearch<double> fine;
      fine.set(search.balls, space.balls, tree);
      Crossing<double> own{Crossing<double>::kNever, Crossing<double>::kNever};
      if (threadIdx.x < few)
        own = fine.crossing_of(space.balls[slots[threadIdx.x]], static_cast<double>(tree.scale));
      if (threadIdx.x == 0) fine_least = ordered_double(Crossing<double>::kNever);
      __syncthreads();
      atomicMin(&fine_least, ordered_double(own.high));
      if (threadIdx.x == 0) candidate_count = 0;
      __syncthreads();
      if (!own.none() && ordered_double(own.low) <= fine_least) {
        const std::uint32_t place = atomicAdd(&candidate_count, 1u);
        fine_slots[place] = slots[threadIdx.x];
      }
      __syncthreads();
      few = candidate_count;
      listed = fine_slots;
    }
    if (fits && few > kMostCandidates && few <= kWideCandidates) {
      const int4 i = search.ball, j = space.balls[search.balls.j], k = space.balls[search.balls.k];
      const LiftedInt vj = lifted_vector(i, i.w, j, j.w), vk = lifted_vector(i, i.w, k, k.w);
      const auto earlier = [&](std::uint32_t a, std::uint32_t b) {
        ExactBest best(vj, vk, search.balls.side);
        for (const std::uint32_t slot : {a, b}) {
          if (slot == kHull) continue;
          const int4 ball = space.balls[slot];
          best.add(lifted_vector(i, i.w, ball, ball.w), slot);
        }
        return best.slot;
      };
      for (std::uint32_t half = kWideCandidates / 2; half > 0; half /= 2) {
        if (threadIdx.x < half && threadIdx.x + half < few)
          fine_slots[threadIdx.x] =
              earlier(fine_slots[threadIdx.x], fine_slots[threadIdx.x + half]);
        __syncthreads();
      }
      if (threadIdx.x == 0) front.apex[ref] = fine_slots[0];
      continue;
    }
    if (threadIdx.x == 0) {
      if (!fits || few > kWideCandidates) {
        space.exact.add(ref);
      } else if (few == 0) {
        front.apex[ref] = kHull;
      } else {
        const std::uint32_t place = space.doubtful.add(ref);
        for (std::uint32_t n = 0; n < kMostCandidates; ++n)
          space.candidates[place].slot[n] = n < few ? listed[n] : kHull;
      }
    }
  }
}

}  // namespace alphascope::gpu
