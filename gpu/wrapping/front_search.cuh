// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the ball before each open face. Eight lanes search one face in the tree, nearest boxes
// first; the four searches of a warp advance in step.
#pragma once

#include "core/wrapping/crossing.hpp"
#include "gpu/wrapping/front.cuh"

namespace alphascope::gpu {

inline constexpr int kSearchThreads = 128;

// Coordinates that are exact in Real.
template <class Real>
struct ExactBelow;
template <>
struct ExactBelow<float> {
  static constexpr std::int64_t limit = std::int64_t{1} << 24;
};
template <>
struct ExactBelow<double> {
  static constexpr std::int64_t limit = std::int64_t{1} << 53;
};

template <class Real>
__device__ inline bool is_exact(const LiftedInt& v) {
  constexpr std::int64_t most = ExactBelow<Real>::limit;
  return v.x < most && v.x > -most && v.y < most && v.y > -most && v.z < most && v.z > -most;
}
template <class Real>
__device__ inline LiftedVector<Real> scaled_lifted(const LiftedInt& v, Real scale) {
  return {static_cast<Real>(v.x) * scale, static_cast<Real>(v.y) * scale,
          static_cast<Real>(v.z) * scale, static_cast<Real>(v.c) * scale * scale};
}

// The part of space in which a ball may touch first: before the plane of the face, and where its
// power from the sphere's centre is at most `limit`. Boxes are in single precision.
struct SearchRegion {
  float hx, hy, hz, plane;  // before: h·x >= plane
  float x, y, z, limit;
  float px, py, pz;  // centre of ball i, from which boxes are sorted

  __device__ bool may_contain(const float4& low, const float4& high) const {
    const float ahead = fmaf(hx, hx > 0 ? high.x : low.x,
                             fmaf(hy, hy > 0 ? high.y : low.y, hz * (hz > 0 ? high.z : low.z)));
    if (!(ahead >= plane)) return false;
    const float dx = fmaxf(fmaxf(low.x - x, x - high.x), 0.0f),
                dy = fmaxf(fmaxf(low.y - y, y - high.y), 0.0f),
                dz = fmaxf(fmaxf(low.z - z, z - high.z), 0.0f);
    return fmaf(dx, dx, fmaf(dy, dy, dz * dz)) - low.w <= limit;
  }
  __device__ float square_distance(const float4& low, const float4& high) const {
    const float dx = fmaxf(fmaxf(low.x - px, px - high.x), 0.0f),
                dy = fmaxf(fmaxf(low.y - py, py - high.y), 0.0f),
                dz = fmaxf(fmaxf(low.z - pz, pz - high.z), 0.0f);
    return fmaf(dx, dx, fmaf(dy, dy, dz * dz));
  }
};

// The best ball of a lane so far, and the least `low` of its other balls.
template <class Real>
struct BestBall {
  Real low, high, second;
  std::uint32_t slot;

  __device__ void clear() {
    low = high = second = Crossing<Real>::kNever;
    slot = kHull;
  }
  __device__ void add(const Crossing<Real>& c, std::uint32_t at) {
    if (at == slot) return;
    if (c.low < low) {
      second = low < second ? low : second;
      low = c.low;
      high = c.high;
      slot = at;
    } else {
      second = c.low < second ? c.low : second;
    }
  }
  // Every lane of the warp must call it.
  __device__ void merge_lanes() {
    for (int step = 1; step < kFan; step *= 2) {
      const Real other_low = __shfl_xor_sync(~0u, low, step);
      const Real other_high = __shfl_xor_sync(~0u, high, step);
      const Real other_second = __shfl_xor_sync(~0u, second, step);
      const std::uint32_t other_slot = __shfl_xor_sync(~0u, slot, step);
      if (other_second < second) second = other_second;
      // The same decision in both lanes, also when the bounds are equal.
      const bool takes = other_low < low || (other_low == low && other_slot < slot);
      const Real loser = takes ? low : other_low;
      if (loser < second) second = loser;
      if (takes) {
        low = other_low;
        high = other_high;
        slot = other_slot;
      }
    }
  }
};

template <class Real>
__device__ inline Real least_of_lanes(Real value) {
  for (int step = 1; step < kFan; step *= 2) {
    const Real other = __shfl_xor_sync(~0u, value, step);
    value = other < value ? other : value;
  }
  return value;
}

// A search as all of its eight lanes know it.
template <class Real>
struct FaceSearch {
  OpenFace<Real> face;
  FaceBalls balls;
  int4 ball;   // i
  Real bound;  // some ball touches at this t or before
  SearchRegion region;

  // False if Real is not precise enough. Double precision always is.
  __device__ bool set(const FaceBalls& of, const int4* all, const BallTree& tree) {
    balls = of;
    ball = all[of.i];
    const int4 j = all[of.j], k = all[of.k];
    const LiftedInt vj = lifted_vector(ball, ball.w, j, j.w),
                    vk = lifted_vector(ball, ball.w, k, k.w);
    const Real scale = static_cast<Real>(tree.scale);
    if (!is_exact<Real>(vj) || !is_exact<Real>(vk) ||
        !face.set(scaled_lifted(vj, scale), scaled_lifted(vk, scale), of.side))
      return false;
    bound = Crossing<Real>::kNever;
    region.px = scaled_offset(ball.x, tree.origin.x, tree.scale);
    region.py = scaled_offset(ball.y, tree.origin.y, tree.scale);
    region.pz = scaled_offset(ball.z, tree.origin.z, tree.scale);
    region.x = region.y = region.z = 0;
    region.limit = 1e38f;
    const Vector3<Real>& n = face.line().direction();
    const float s = of.side > 0 ? 1.0f : -1.0f;
    region.hx = s * static_cast<float>(n.x);
    region.hy = s * static_cast<float>(n.y);
    region.hz = s * static_cast<float>(n.z);
    const float at = fmaf(region.hx, region.px, fmaf(region.hy, region.py, region.hz * region.pz));
    // Coordinates from the origin err by one rounding, the normal by four, and the sums by three,
    // of sizes up to the tree's extent, 2^12.
    const float size = fabsf(region.hx) + fabsf(region.hy) + fabsf(region.hz);
    region.plane = at - 16 * Rounding<float>::u * 4096 * size;
    return true;
  }

  // Limits the region to the sphere at `t`. `weight`: the largest of all balls.
  __device__ void limit_to(Real t, const BallTree& tree, float weight) {
    bound = t;
    if (!(t < Crossing<Real>::kNever)) return;
    constexpr float u = Rounding<float>::u;
    const Vector3<Real>&n = face.line().direction(), &foot = face.line().foot();
    const Real s = face.side() > 0 ? t : -t;
    const auto x = static_cast<float>(foot.x + s * n.x), y = static_cast<float>(foot.y + s * n.y),
               z = static_cast<float>(foot.z + s * n.z);
    const float square = fmaf(x, x, fmaf(y, y, z * z));
    if (!(square < 1e30f)) return;
    region.x = region.px + x;
    region.y = region.py + y;
    region.z = region.pz + z;
    const float radius = static_cast<float>(ball.w) * tree.scale;
    const auto f = static_cast<float>(largest_coordinate(foot)),
               along = static_cast<float>(magnitude(t) * largest_coordinate(n));
    // The centre's error, for all three coordinates together.
    const float error = 1.75f * (static_cast<float>(face.line().foot_error()) +
                                 8 * u * (f + along) + 4 * u * (4096 + f + along));
    const float reach = sqrtf(square + weight) * 1.001f + error;
    region.limit = square - radius * radius + 6 * error * reach + 32 * u * (square + weight);
  }
};

// Searches the faces of this round (single precision), or those that this left undecided (double
// precision and integers). `own`: 0 for the first, else the list's places.
template <class Real>
__global__ void __launch_bounds__(kSearchThreads)
    search_faces(Front front, BallTree tree, const int4* balls, const std::uint32_t* place,
                 float weight) {
  constexpr bool kExact = sizeof(Real) == sizeof(double);
  FrontCounts& counts = *front.counts;
  if (counts.full != 0) return;
  const std::uint32_t end = kExact ? counts.unsure : counts.end;
  std::uint32_t* const next = kExact ? &counts.next_unsure : &counts.next;
  const int lane = static_cast<int>(threadIdx.x & 31), sub = lane % kFan, group = lane - sub;
  const auto of_group = [&](unsigned bits) { return bits >> group & 0xffu; };

  FaceSearch<Real> search;
  BestBall<Real> best;
  best.clear();
  LiftedInt vj{}, vk{}, exact_best{};  // kernel III alone
  bool active = false, finished = false;
  std::uint32_t at = 0;  // place in the queue
  int level = 0;         // of the node
  std::uint32_t node = 0, mask = 0;
  std::uint64_t pending = 0;  // the untested children of the nodes above, a byte for each level
  int seeds = 0;              // leaves of the face's own balls that are still to be looked at

  for (;;) {
    // Idle lanes take the next face.
    while (__any_sync(~0u, !active && !finished)) {
      std::uint32_t taken = 0;
      if (!active && !finished && sub == 0) taken = atomicAdd(next, 1u);
      taken = __shfl_sync(~0u, taken, group);
      if (active || finished) continue;
      if (taken >= end) {
        finished = true;
        continue;
      }
      at = kExact ? front.unsure[taken] : taken;
      const FaceRef ref = front.queue[at];
      if (!kExact && front.faces.neighbours[ref] != kOpen) {
        if (sub == 0) front.apex[at] = kClosed;
        continue;
      }
      const FaceBalls face = face_of(front.faces.quads[ref >> 2], static_cast<int>(ref & 3));
      if (!search.set(face, balls, tree)) {
        if (sub == 0) {
          front.apex[at] = kUnsure;
          front.unsure[atomicAdd(&counts.unsure, 1u)] = at;
        }
        continue;
      }
      if (kExact) {
        const int4 i = search.ball, j = balls[search.balls.j], k = balls[search.balls.k];
        vj = lifted_vector(i, i.w, j, j.w);
        vk = lifted_vector(i, i.w, k, k.w);
      }
      best.clear();
      active = true;
      seeds = 3;
      pending = 0;
    }
    if (!__any_sync(~0u, active)) return;

    if (active && seeds > 0) {
      const std::uint32_t slot = seeds == 3   ? search.balls.i
                                 : seeds == 2 ? search.balls.j
                                              : search.balls.k;
      node = place[slot] / kFan;
      level = 0;
      mask = 0;
    }

    // Leaves: each lane takes a ball.
    const bool at_leaf = active && level == 0;
    if (__any_sync(~0u, at_leaf)) {
      bool improves = false;
      const std::uint32_t m = node * kFan + sub;
      if (at_leaf && m < tree.balls) {
        const int4 b = tree.ball[m];
        const std::uint32_t slot = tree.slot[m];
        if (slot != search.balls.i && slot != search.balls.j && slot != search.balls.k) {
          const int4& i = search.ball;
          const Real scale = static_cast<Real>(tree.scale);
          const Real weights =
              static_cast<Real>(i.w - b.w) * scale * (static_cast<Real>(i.w + b.w) * scale);
          const Crossing<Real> c = search.face.crossing(rough_lifted(
              static_cast<Real>(b.x - i.x) * scale, static_cast<Real>(b.y - i.y) * scale,
              static_cast<Real>(b.z - i.z) * scale, weights));
          if (!c.none() && c.low <= search.bound) {
            if constexpr (kExact) {
              const LiftedInt v = lifted_vector(i, i.w, b, b.w);
              const int side = sign_of(determinant(vj, vk, v)) * search.balls.side;
              const bool same = best.slot != kHull && v.x == exact_best.x && v.y == exact_best.y &&
                                v.z == exact_best.z && v.c == exact_best.c;
              if (side > 0 && slot != best.slot &&
                  (best.slot == kHull ||
                   (same ? slot < best.slot : touches_before(vj, vk, exact_best, v)))) {
                best.slot = slot;
                exact_best = v;
              }
              if (side > 0 && c.high < best.high) {
                best.high = c.high;
                improves = true;
              }
            } else {
              const Real before = best.high;
              best.add(c, slot);
              improves = best.high < before && best.high < search.bound;
            }
          }
        }
      }
      if (__any_sync(~0u, improves)) {
        const Real least = least_of_lanes(best.high);
        if (at_leaf && least < search.bound) search.limit_to(least, tree, weight);
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
        if (passes) key = search.region.square_distance(low, high);
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

    if (__any_sync(~0u, done)) {
      if constexpr (kExact) {
        // Lane 0 of the eight compares the best balls of all.
        for (int other = 1; other < kFan; ++other) {
          const std::uint32_t slot = __shfl_sync(~0u, best.slot, group + other);
          if (!done || sub != 0 || slot == kHull) continue;
          const int4 i = search.ball, b = balls[slot];
          const LiftedInt v = lifted_vector(i, i.w, b, b.w);
          const bool same = best.slot != kHull && v.x == exact_best.x && v.y == exact_best.y &&
                            v.z == exact_best.z && v.c == exact_best.c;
          if (best.slot == kHull ||
              (same ? slot < best.slot : touches_before(vj, vk, exact_best, v))) {
            best.slot = slot;
            exact_best = v;
          }
        }
        if (done && sub == 0) front.apex[at] = best.slot;
      } else {
        BestBall<Real> all = best;
        all.merge_lanes();
        if (done && sub == 0) {
          const bool sure = all.slot == kHull || all.high < all.second;
          front.apex[at] = sure ? all.slot : kUnsure;
          if (!sure) front.unsure[atomicAdd(&counts.unsure, 1u)] = at;
        }
      }
      if (done) active = false;
    }
  }
}

}  // namespace alphascope::gpu
