// SPDX-License-Identifier: GPL-3.0-or-later
// Kernel I: makes the ordered neighbour lists of a block's balls. Neighbours without a facet are
// left out of long lists (facet_disc.hpp explains which and why).
#pragma once

#include <cfloat>
#include <climits>

#include "gpu/dual_edge/dual_edge_rows.cuh"

namespace alphascope::gpu {

// Kernel III does not cull lists up to this length, because culling would cost more than it saves.
constexpr int kShortList = 32;

// Marks in the upper bits of an index in an unfinished list.
constexpr std::uint32_t kNearBit = 1u << 31, kDeadBit = 1u << 30, kIndexBits = kDeadBit - 1;

template <class Kind>
__device__ inline std::uint32_t index_of(std::uint32_t found) {
  return Kind::kCull ? found & kIndexBits : found;
}

__device__ inline int lane_of_half() {
  return threadIdx.x & (kSearchLanes - 1);
}
// The votes of the lanes of this half warp.
__device__ inline unsigned half_ballot(bool vote) {
  return __ballot_sync(~0u, vote) >> (threadIdx.x & kSearchLanes) & 0xffffu;
}

__device__ inline std::int64_t square(int a) {
  return static_cast<std::int64_t>(a) * a;
}

// The scaled vector of ball q as seen from `centre`. `*inside`: the centre has less power to its
// own ball than to q. Differences of neighbours have at most 25 bits with the sign, as floats have,
// so they are exact; c is rounded once.
__device__ inline LiftedVector<float> scaled_vector(const DualEdgeProblem& p, const int4& centre,
                                                    const int4& q, bool* inside) {
  const auto difference = [](int a, int b) {
    return static_cast<int>(static_cast<unsigned>(a) - static_cast<unsigned>(b));
  };
  const int x = difference(q.x, centre.x), y = difference(q.y, centre.y),
            z = difference(q.z, centre.z);
  float c = 0;
  if (p.narrow) {
    const int narrow = x * x + y * y + z * z + (centre.w * centre.w - q.w * q.w);
    *inside = narrow > 0;
    c = static_cast<float>(narrow);
  } else {
    const LiftedInt wide = lifted_vector(centre, centre.w, q, q.w);
    *inside = wide.c > 0;
    c = static_cast<float>(wide.c);
  }
  const float scale = p.common.scale;
  return {static_cast<float>(x) * scale, static_cast<float>(y) * scale,
          static_cast<float>(z) * scale, c * p.radius_scale};
}

// Leaves out those of the `n` balls found by a half warp that have no facet. Both halves of a warp
// must call it, each for its ball.
class Culler {
 public:
  __device__ Culler(const DualEdgeProblem& p, const DualEdgeMemory& m, const int4& centre,
                    float radius_square, int n)
      : p_(p),
        m_(m),
        centre_(centre),
        radius_square_(radius_square),
        n_(n),
        // number of rounds: that of the longer list of both halves
        end_(max(n, __shfl_xor_sync(~0u, n, kSearchLanes))) {}

  // Returns the number of remaining balls. Marks those with the nearest planes, and those without
  // facet that are still needed.
  __device__ int cull() {
    const bool attached = measure();
    const float nearest = threshold();
    const int coverers = list_coverers(nearest);
    return leave_out(coverers, attached);
  }

 private:
  __device__ LiftedVector<float> vector(int a, bool* inside) const {
    return scaled_vector(p_, centre_, p_.balls[m_.found[a] & kIndexBits], inside);
  }
  __device__ float& key(int a) const { return reinterpret_cast<float*>(m_.found_index)[a]; }

  // Sets the keys: twice the distances of the planes. Returns whether the ball's centre is outside
  // its cell.
  __device__ bool measure() const {
    bool all_inside = true;
    for (int a = lane_of_half(); a < n_; a += kSearchLanes) {
      bool inside = false;
      const LiftedVector<float> v = vector(a, &inside);
      key(a) = v.c * rough_reciprocal(rough_square_root(fmaf(v.x, v.x, fmaf(v.y, v.y, v.z * v.z))));
      all_inside = all_inside && inside;
    }
    __syncwarp();
    return half_ballot(!all_inside) != 0;
  }

  // A threshold with at most kCoverers keys at or below it. A few halvings try to bring the number
  // near kCoverers. Any threshold is correct: fewer coverers only leave more balls in the list.
  __device__ float threshold() const {
    float enough = n_ <= kCoverers ? FLT_MAX : -FLT_MAX, low = 0,
          high = 2 * rough_square_root(fmaxf(radius_square_, 1e-30f));
    bool found = n_ <= kCoverers;
    for (int step = 0; step < 8 && __any_sync(~0u, !found); ++step) {
      const float middle = 0.5f * (low + high);
      int count = 0;
      for (int a = lane_of_half(); a - lane_of_half() < end_; a += kSearchLanes)
        count += __popc(half_ballot(a < n_ && key(a) <= middle));
      if (found) continue;
      (count <= kCoverers ? low : high) = middle;
      if (count <= kCoverers) enough = middle;
      found = count <= kCoverers && count >= kCoverers - 3;
    }
    return enough;
  }

  __device__ int list_coverers(float nearest) const {
    int count = 0;
    for (int a = lane_of_half(); a - lane_of_half() < end_; a += kSearchLanes) {
      const bool near = a < n_ && key(a) <= nearest;
      const unsigned all = half_ballot(near);
      if (near) {
        bool inside = false;
        const auto m = FacetDisc<float>::coverer(vector(a, &inside));
        const int at = count + __popc(all & ((1u << lane_of_half()) - 1));
        m_.coverers[at] = make_float4(m.d.x, m.d.y, m.d.z, m.d.c);
        m_.coverer_lengths[at] = m.length;
        m_.found[a] |= kNearBit;
      }
      count += __popc(all);
    }
    __syncwarp();
    return count;
  }

  __device__ bool has_no_facet(const LiftedVector<float>& v, int coverers) const {
    const FacetDisc<float> disc(v, radius_square_);
    if (disc.certainly_empty()) return true;
    for (int r = 0; r < coverers; ++r) {
      const float4 d = m_.coverers[r];
      if (disc.covered_by({{d.x, d.y, d.z, d.w}, m_.coverer_lengths[r]})) return true;
    }
    return false;
  }

  // Shortens the list in place: each round writes only to entries that all lanes have read already.
  __device__ int leave_out(int coverers, bool attached) const {
    int left = 0;
    for (int a = lane_of_half(); a - lane_of_half() < end_; a += kSearchLanes) {
      std::uint32_t marked = 0;
      bool dead = true;
      if (a < n_) {
        bool inside = false;
        marked = m_.found[a];
        dead = has_no_facet(vector(a, &inside), coverers);
        if (dead) marked |= kDeadBit;
      }
      const bool stays = a < n_ && (attached || !dead);
      const unsigned all = half_ballot(stays);
      if (stays) m_.found[left + __popc(all & ((1u << lane_of_half()) - 1))] = marked;
      left += __popc(all);
      __syncwarp();
    }
    return left;
  }

  const DualEdgeProblem& p_;
  const DualEdgeMemory& m_;
  const int4 centre_;
  const float radius_square_;
  const int n_, end_;
};

// The list of ball b: `n` balls from entry0 on.
struct BallList {
  int b, n, entry0;
  const int4& centre;
};

// Writes a list ordered by index, with vectors relative to its ball. Three values ~0u must follow
// the indices in found_index, because four are read at once. Called by half a warp. Returns true in
// a lane that met a ball whose power at the centre is not larger.
template <class Kind>
__device__ inline bool order_list(const Block& block, const SortedBalls& sorted,
                                  const BallList& list) {
  const DualEdgeProblem& p = block.p;
  const DualEdgeMemory& m = block.m;
  bool attached = false;
  for (int a = lane_of_half(); a < list.n; a += kSearchLanes) {
    const std::uint32_t found = m.found[a], index = m.found_index[a];
    const float reach = sorted.home[index].reach * p.common.scale;
    int rank = 0;
    for (int o = 0; o < list.n; o += 4) {
      const uint4 others = *reinterpret_cast<const uint4*>(m.found_index + o);
      rank += (others.x < index) + (others.y < index) + (others.z < index) + (others.w < index);
    }
    bool inside = false;
    const LiftedVector<float> v = scaled_vector(p, list.centre, p.balls[index], &inside);
    const int entry = list.entry0 + rank, word = list.b * p.words + (rank >> 5);
    m.vectors[entry] = make_float4(v.x, v.y, v.z, v.c);
    m.reach[entry] = reach;
    m.index[entry] = index;
    if (Kind::kEdges && !(Kind::kCull && (found & kDeadBit)))
      atomicOr(&m.possible[word], 1u << (rank & 31));
    if (Kind::kCull && (found & kNearBit)) atomicOr(&m.near[word], 1u << (rank & 31));
    attached = attached || !inside;
  }
  return attached;
}

// Numbers of balls: found, left in the list, and of higher index among these.
struct ListCounts {
  int found, left, later;
};

// Notes the sizes of a ball's list, from which the next run's room follows.
template <class Kind>
__device__ inline void note_list(const Block& block, int found, int left) {
  const DualEdgeProblem& p = block.p;
  BlockStatistics& met = *block.out.statistics;
  const bool fits = found <= p.common.search_capacity,
             too_long = !fits || left > static_cast<int>(p.capacity.list);
  if (Kind::kExact || !fits) note_largest(&met.most_found, found);
  if (Kind::kExact || too_long) note_largest(&met.longest_list, left);
  if (!Kind::kExact && too_long) atomicAdd(&met.too_long, 1u);
  if (Kind::kExact || !is_sampled(p)) return;
  measure(block.s.all_found, found);
  if (fits) measure(block.s.all_lists, left);
}
// Notes the sizes of a sampled block. Called by one thread.
__device__ inline void note_lists(BlockStatistics& met, const BlockBalls& s) {
  add_measured(met.found, s.all_found);
  add_measured(met.list, s.all_lists);
  measure(met.entries, s.entries);
  measure(met.rows, s.rows);
}

// The place of a half warp's list.
struct ListPlace {
  int entry0, row0;
  bool room;
};

// Both halves of a warp must call it.
__device__ inline ListPlace place_list(const DualEdgeProblem& p, BlockBalls& s, bool active,
                                       const ListCounts& counts) {
  const int half = threadIdx.x & kSearchLanes;
  int entry0 = 0, row0 = 0;
  if (lane_of_half() == 0 && active) {
    entry0 = atomicAdd(&s.entries, counts.left);
    row0 = atomicAdd(&s.rows, counts.later);
  }
  entry0 = __shfl_sync(~0u, entry0, half);
  row0 = __shfl_sync(~0u, row0, half);
  return {entry0, row0,
          counts.found <= p.common.search_capacity &&
              counts.left <= static_cast<int>(p.capacity.list) &&
              entry0 + counts.left <= static_cast<int>(p.capacity.entries) &&
              row0 + counts.later <= static_cast<int>(p.capacity.rows)};
}

// Marks rows with their ball. Rows of a ball without room count too, but belong to no ball.
__device__ inline void mark_rows(const DualEdgeProblem& p, const DualEdgeMemory& m,
                                 const ListPlace& place, int later, int b) {
  const int owner = place.room ? b : kMaxBallsPerBlock;
  const int end = min(place.row0 + later, static_cast<int>(p.capacity.rows));
  for (int row = place.row0 + lane_of_half(); row < end; row += kSearchLanes)
    m.row_ball[row] = static_cast<std::uint8_t>(owner);
}

// Copies the found indices to found_index. Returns how many are above the ball's.
template <class Kind>
__device__ inline int count_later(const DualEdgeMemory& m, int n, std::uint32_t index) {
  int later = 0;
  for (int a = lane_of_half(); __any_sync(~0u, a < n); a += kSearchLanes) {
    const std::uint32_t other = a < n ? index_of<Kind>(m.found[a]) : 0;
    if (a < n) m.found_index[a] = other;
    later += __popc(half_ballot(other > index));
  }
  // Sentinels, because order_list() reads four at once.
  if (lane_of_half() < 3) m.found_index[n + lane_of_half()] = ~0u;
  __syncwarp();  // order_list() reads what other lanes wrote
  return later;
}

// Stores the data of a ball whose list is made. Called by one lane.
__device__ inline void keep_ball(BlockBalls& s, int b, const ListPlace& place,
                                 const ListCounts& counts) {
  s.list[b] = place.room ? counts.left : 0;
  s.later[b] = place.room ? counts.later : 0;
  s.entry0[b] = place.entry0;
  s.row0[b] = place.row0;
  s.first_triangle[b] = INT_MAX;
  s.end_triangle[b] = 0;
  s.exact[b] = place.room ? 0 : 2;
}

// Makes the list of ball b of the block by half a warp. Not `active`: there is no ball. Both halves
// of a warp must call it.
template <class Kind>
__device__ inline void find_list(const Block& block, const SortedBalls& sorted, int b,
                                 bool active) {
  const DualEdgeProblem& p = block.p;
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  const std::uint32_t index = block.first + b;
  const BallCell home = sorted.home[index];
  const int4 centre = p.balls[index];
  const bool alive = home.reach >= 0;
  const int all = search_neighbours(p.common, sorted, home, active && alive,
                                    {s.reachable[threadIdx.x / kSearchLanes], m.found});
  const float radius_square =
      static_cast<float>(p.common.alpha.plus(square(centre.w))) * p.radius_scale;
  int n = all <= p.common.search_capacity ? all : 0;
  if constexpr (Kind::kCull) {
    if (!Kind::kExact || __any_sync(~0u, n > kShortList))
      n = Culler(p, m, centre, radius_square, n).cull();
  }
  const ListCounts counts{all, n, count_later<Kind>(m, n, index)};
  const ListPlace place = place_list(p, s, active, counts);
  if (active) mark_rows(p, m, place, counts.later, b);
  const bool lane_attached =
      active && place.room &&
      order_list<Kind>(block, sorted, {b, counts.left, place.entry0, centre});
  const bool attached = half_ballot(lane_attached) != 0;
  if (active && lane_of_half() == 0) {
    s.radius_square[b] = radius_square;
    s.ball[b] = centre;
    s.index[b] = index;
    s.state[b] = !alive ? 0 : attached ? 1 : 2;
    keep_ball(s, b, place, counts);
    if (alive) note_list<Kind>(block, counts.found, counts.left);
  }
  __syncwarp();
}

// Kernel I of the block's balls, one half warp for each: makes their ordered lists. Balls without
// room are marked.
template <class Kind>
__device__ inline void find_lists(const Block& block, const SortedBalls& sorted) {
  const DualEdgeProblem& p = block.p;
  const DualEdgeMemory& m = block.m;
  BlockBalls& s = block.s;
  if (threadIdx.x == 0) {
    s.all_found = s.all_lists = {};
    s.entries = s.rows = s.listed = s.next_listed = s.probed = s.next_work = s.kept = 0;
  }
  if (threadIdx.x < kLengths) s.lengths[threadIdx.x] = 0;
  for (int w = threadIdx.x; w < block.balls * p.words; w += kBlockThreads)
    m.possible[w] = m.near[w] = 0;
  __syncthreads();
  const int half = (threadIdx.x & kSearchLanes) != 0 ? 1 : 0;
  for (int pair = threadIdx.x >> 5; 2 * pair < block.balls; pair += kBlockThreads / 32) {
    // With an odd number of balls, the second half of the last pair repeats the reads of the first,
    // and its results are not used.
    const bool active = 2 * pair + half < block.balls;
    const int b = 2 * pair + (active ? half : 0);
    find_list<Kind>(block, sorted, b, active);
  }
  __syncthreads();
  if (threadIdx.x == 0) {
    if (!Kind::kExact && is_sampled(p)) note_lists(*block.out.statistics, s);
    s.rows = min(s.rows, static_cast<int>(p.capacity.rows));
  }
  __syncthreads();
}

}  // namespace alphascope::gpu
