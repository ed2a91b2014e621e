// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ball before each open face in the tree, nearest boxes first. The four searches of a
// warp advance in step.
#pragma once

#include <type_traits>

#include "gpu/wrapping/face_search.cuh"

namespace alphascope::gpu {

// A search in single precision that takes more steps leaves its face to search_widely(). Few faces
// do not keep the device busy, and blocks are sooner done with them if they have room for all
// leaves.
inline constexpr int kMostSteps = 384;
inline constexpr unsigned kFewFaces = 4;              // for each block
inline constexpr std::uint32_t kWideNodes = 1 << 14;  // of one level, for which a block has room
__device__ inline int most_steps(const BallTree& tree, std::uint32_t faces) {
  return tree.count[0] <= kWideNodes && faces <= kFewFaces * gridDim.x ? tree.top * tree.top
                                                                       : kMostSteps;
}

// kByIntegers: decides every face. Else single precision does what it can.
template <bool kByIntegers, bool kSmall = false>
__global__ void __launch_bounds__(kSearchThreads, kByIntegers ? 1 : 7)
    search_tree(Front front, SearchSpace space, SearchTask task) {
  using Real = std::conditional_t<kByIntegers, double, float>;
  const BallTree& tree = space.tree;
  const std::uint32_t end = *task.count;
  const int most = most_steps(tree, end);
  const int lane = static_cast<int>(threadIdx.x & 31), sub = lane % kFan, group = lane - sub;
  const auto of_group = [&](unsigned bits) { return bits >> group & 0xffu; };

  FaceSearch<Real> search;
  BestBalls best;
  best.clear();
  ExactBest exact({}, {}, 0);
  Real exact_high = 0;
  int steps = 0;
  bool active = false, finished = false;
  FaceRef ref = 0;
  int level = 0;  // of the node
  std::uint32_t node = 0, mask = 0;
  std::uint64_t pending = 0;  // the untested children of the nodes above, a byte for each level
  std::uint32_t seed[3] = {0, 0, 0};
  int seeds = 0;  // leaves of the face's own balls that are still to be looked at

  for (;;) {
    // Idle lanes take the next face.
    while (__any_sync(~0u, !active && !finished)) {
      std::uint32_t taken = 0;
      bool claimed = false;
      if (!active && !finished && sub == 0) {
        taken = atomicAdd(task.next, 1u);
        // One lane reads what others may change, since its eight lanes must agree.
        if (!kByIntegers && taken < end)
          claimed = __ldcg(&front.apex[task.faces[taken]]) == kClaimed;
      }
      taken = __shfl_sync(~0u, taken, group);
      claimed = __shfl_sync(~0u, claimed, group);
      if (active || finished) continue;
      if (taken >= end) {
        finished = true;
        continue;
      }
      if (claimed) continue;
      ref = task.faces[taken];
      const FaceBalls face = face_of(front.faces.quads[ref >> 2], static_cast<int>(ref & 3));
      if (!search.set(face, space.balls, tree)) {
        if (sub == 0) space.exact.add(ref);
        continue;
      }
      if constexpr (kByIntegers) {
        const int4 i = search.ball, j = space.balls[face.j], k = space.balls[face.k];
        exact = ExactBest(lifted_vector(i, i.w, j, j.w), lifted_vector(i, i.w, k, k.w), face.side);
        exact_high = Crossing<Real>::kNever;
      }
      best.clear();
      steps = 0;
      active = true;
      seeds = 3;
      seed[0] = space.place[face.i] / kFan;
      seed[1] = space.place[face.j] / kFan;
      seed[2] = space.place[face.k] / kFan;
      pending = 0;
      if (task.bounds != nullptr && task.bounds[taken] < Crossing<float>::kNever) {
        search.limit_to(static_cast<Real>(task.bounds[taken]), tree, space.weight);
        seeds = 0;
        seed[0] = seed[1] = seed[2] = ~0u;
        level = tree.top;
        node = 0;
        mask = 0xff;
      }
    }
    if (!__any_sync(~0u, active)) return;

    if (active && seeds > 0) {
      node = seeds == 3 ? seed[0] : seeds == 2 ? seed[1] : seed[2];
      level = 0;
      mask = 0;
    }

    // Leaves: each lane takes a ball.
    const bool at_leaf = active && level == 0;
    const bool again =
        seeds == 0 && at_leaf && (node == seed[0] || node == seed[1] || node == seed[2]);
    if (__any_sync(~0u, at_leaf)) {
      bool improves = false;
      const std::uint32_t m = node * kFan + sub;
      if (at_leaf && !again && m < tree.balls) {
        const int4 b = tree.ball[m];
        const std::uint32_t slot = tree.slot[m];
        if (slot != search.balls.i && slot != search.balls.j && slot != search.balls.k) {
          const Crossing<Real> c =
              search.template crossing_of<kSmall>(b, static_cast<Real>(tree.scale));
          if (!c.none() && c.low <= search.bound) {
            if constexpr (kByIntegers) {
              const int4& i = search.ball;
              if (exact.add(lifted_vector(i, i.w, b, b.w), slot) && c.high < exact_high) {
                exact_high = c.high;
                improves = true;
              }
            } else {
              best.add(c, slot);
              improves = best.high < search.bound;
            }
          }
        }
      }
      if (__any_sync(~0u, improves)) {
        Real least;
        if constexpr (kByIntegers) {
          least = least_of_lanes(exact_high);
        } else {
          least = least_of_lanes(best.high);
        }
        if (at_leaf && least < search.bound) search.limit_to(least, tree, space.weight);
      }
    }

    // Other nodes: each lane takes a child's box.
    const bool at_node = active && level > 0;
    float key = 1e38f;
    bool passes = false;
    if (at_node) {
      const std::uint32_t child = node * kFan + sub;
      if ((mask >> sub & 1) != 0 && child < tree.count[level - 1]) {
        const std::uint32_t box = tree.first[level - 1] + child;
        const float4 low = tree.boxes.low[box], high = tree.boxes.high[box];
        passes = search.region.may_contain(low, high);
        if (passes) key = search.region.from_ball(low, high);
      }
    }
    const unsigned left = of_group(__ballot_sync(~0u, passes));
    const float nearest = least_of_lanes(key);
    const unsigned nearest_lanes = of_group(__ballot_sync(~0u, passes && key == nearest));

    bool climbs = false;
    if (at_leaf) {
      if (seeds > 0) {
        --seeds;
        if (seeds == 0) {  // from the top now
          pending = 0;
          level = tree.top;
          node = 0;
          mask = 0xff;
          climbs = level == 0;  // the tree is one leaf, which was looked at
        }
      } else {
        climbs = true;
      }
    } else if (at_node) {
      if (left == 0) {
        climbs = true;
      } else {
        const int chosen = __ffs(static_cast<int>(nearest_lanes)) - 1;
        pending |= static_cast<std::uint64_t>(left & ~(1u << chosen)) << 8 * level;
        --level;
        node = node * kFan + chosen;
        mask = 0xff;
      }
    }
    bool done = false;
    if (climbs) {
      if (pending == 0) {
        done = true;
      } else {
        const int up = (__ffsll(static_cast<long long>(pending)) - 1) / 8;
        node >>= 3 * (up - level);
        level = up;
        mask = static_cast<std::uint32_t>(pending >> 8 * level) & 0xffu;
        pending &= ~(std::uint64_t{0xff} << 8 * level);
      }
    }

    if constexpr (!kByIntegers) {
      const bool too_long = active && !done && ++steps > most;
      if (too_long) {
        if (sub == 0) space.bounds[space.wide.add(ref)] = search.bound;
        active = false;
      }
    }
    if (__any_sync(~0u, done)) {
      if constexpr (kByIntegers) {
        // Lane 0 of the eight compares the best balls of all.
        for (int other = 1; other < kFan; ++other) {
          const std::uint32_t slot = __shfl_sync(~0u, exact.slot, group + other);
          if (!done || sub != 0 || slot == kHull) continue;
          const int4 i = search.ball, b = space.balls[slot];
          exact.add(lifted_vector(i, i.w, b, b.w), slot);
        }
        if (done && sub == 0) front.apex[ref] = exact.slot;
      } else {
        const std::uint32_t apex = end_search(front, space, done, ref, best);
        claim_others(front, search.balls, apex);
      }
      if (done) active = false;
    }
  }
}

}  // namespace alphascope::gpu
