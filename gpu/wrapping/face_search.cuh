// SPDX-License-Identifier: GPL-3.0-or-later
// A search for the ball before an open face. Eight lanes share it, and a warp has four.
#pragma once

#include <limits>
#include <type_traits>

#include "core/wrapping/crossing.hpp"
#include "gpu/wrapping/front.cuh"

namespace alphascope::gpu {

inline constexpr int kSearchThreads = 128;
inline constexpr unsigned kSearchBlocks = 8;  // for each multiprocessor

// Does Real hold the coordinates exactly?
template <class Real>
__device__ inline bool is_exact(const LiftedInt& v) {
  constexpr std::int64_t most = std::int64_t{1} << std::numeric_limits<Real>::digits;
  return v.x < most && v.x > -most && v.y < most && v.y > -most && v.z < most && v.z > -most;
}
template <class Real>
__device__ inline LiftedVector<Real> scaled_lifted(const LiftedInt& v, Real scale) {
  return {static_cast<Real>(v.x) * scale, static_cast<Real>(v.y) * scale,
          static_cast<Real>(v.z) * scale, static_cast<Real>(v.c) * scale * scale};
}

// An integer as a Real. With `kSmall`, for |value| <= kMostSmall only, and faster: a conversion
// takes eight times as long as a sum.
inline constexpr int kMostSmall = (1 << 22) - 1;
template <class Real, bool kSmall>
__device__ inline Real real_of(int value) {
  if constexpr (kSmall && std::is_same_v<Real, float>) {
    constexpr float base = 3 << 22;  // 0x4b400000, of which the last bit counts 1
    return __uint_as_float(0x4b400000u + static_cast<unsigned>(value)) - base;
  } else {
    return static_cast<Real>(value);
  }
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
    return square_distance(x, y, z, low, high) - low.w <= limit;
  }
  __device__ float from_ball(const float4& low, const float4& high) const {
    return square_distance(px, py, pz, low, high);
  }

 private:
  __device__ static float square_distance(float x, float y, float z, const float4& low,
                                          const float4& high) {
    const float dx = fmaxf(fmaxf(low.x - x, x - high.x), 0.0f),
                dy = fmaxf(fmaxf(low.y - y, y - high.y), 0.0f),
                dz = fmaxf(fmaxf(low.z - z, z - high.z), 0.0f);
    return fmaf(dx, dx, fmaf(dy, dy, dz * dz));
  }
};

// The two balls of a lane that may touch earliest, and the least bound of its other balls.
struct BestBalls {
  float low, high, second_low, third_low;
  std::uint32_t slot, second;

  __device__ void clear() {
    low = high = second_low = third_low = Crossing<float>::kNever;
    slot = second = kHull;
  }
  __device__ void add(const Crossing<float>& c, std::uint32_t at) {
    if (at == slot || at == second || c.none()) return;
    if (c.low < low) {
      third_low = second_low;
      second_low = low;
      second = slot;
      low = c.low;
      slot = at;
    } else if (c.low < second_low) {
      third_low = second_low;
      second_low = c.low;
      second = at;
    } else if (c.low < third_low) {
      third_low = c.low;
    }
    if (c.high < high) high = c.high;
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

  template <bool kSmall>
  __device__ RoughLifted<Real> lifted(const int4& b, Real scale) const {
    const auto real = [](int value) { return real_of<Real, kSmall>(value); };
    const Real weights = real(ball.w - b.w) * scale * (real(ball.w + b.w) * scale);
    return rough_lifted(real(b.x - ball.x) * scale, real(b.y - ball.y) * scale,
                        real(b.z - ball.z) * scale, weights);
  }
  template <bool kSmall = false>
  __device__ Crossing<Real> crossing_of(const int4& b, Real scale) const {
    return face.crossing(lifted<kSmall>(b, scale));
  }
  // Roughly the radius of the sphere that touches ball b, too, or 0 if its centre is behind the
  // face. `at_foot`: the power of the foot from ball i.
  template <bool kSmall>
  __device__ Real radius_with(const int4& b, Real scale, Real at_foot) const {
    const auto cut = face.line().line_cut(lifted<kSmall>(b, scale).v);
    const Real s = cut.offset * rough_reciprocal(cut.slope);
    if (!(face.side() > 0 ? s > 0 : s < 0)) return 0;
    return sqrtf(fmaxf(at_foot + s * s * face.line().direction_square(), Real(0)));
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
    const float reach = rough_square_root(square + weight) * 1.001f + error;
    region.limit = square - radius * radius + 6 * error * reach + 32 * u * (square + weight);
  }
};

// The ball that touches first, by integers.
struct ExactBest {
  LiftedInt j, k;
  int side;
  LiftedInt ball{};
  std::uint32_t slot = kHull;

  __device__ ExactBest(const LiftedInt& j_, const LiftedInt& k_, int side_)
      : j(j_), k(k_), side(side_) {}
  // Returns whether the ball is in front.
  __device__ bool add(const LiftedInt& v, std::uint32_t at) {
    if (at == slot) return true;
    if (sign_of(determinant(j, k, v)) != side) return false;
    // Equal balls at one centre are in the order of their indices, and so are their slots.
    const bool same =
        slot != kHull && v.x == ball.x && v.y == ball.y && v.z == ball.z && v.c == ball.c;
    if (slot == kHull || (same ? at < slot : touches_before(j, k, ball, v))) {
      slot = at;
      ball = v;
    }
    return true;
  }
};

// Faces that several balls may touch first. Integers decide between those.
inline constexpr int kMostCandidates = 8;
struct Candidates {
  std::uint32_t slot[kMostCandidates];  // kHull after the last
};

// Faces that a search leaves to another.
struct SearchList {
  FaceRef* faces;
  std::uint32_t* count;

  __device__ std::uint32_t add(FaceRef face) const {
    const std::uint32_t at = atomicAdd(count, 1u);
    faces[at] = face;
    return at;
  }
};

// Faces to search, and the number of those taken. `bounds`: some ball touches at this t or before,
// or null.
struct SearchTask {
  const FaceRef* faces;
  const float* bounds;
  const std::uint32_t* count;
  std::uint32_t* next;
};

// What the searches of a round share.
struct SearchSpace {
  BallTree tree;
  const int4* balls;           // by slot
  const std::uint32_t* place;  // in the tree, of each slot that has an open face
  float weight;                // the largest of all balls, scaled
  SearchList doubtful;         // with `candidates`
  Candidates* candidates;
  SearchList wide;  // with `bounds`: some ball touches at this t or before
  float* bounds;
  SearchList exact;
};

// Ends a search of eight lanes whose balls are in `best`. Every lane of the warp must call it;
// `ends`: whether the lane's search ends. Writes the apex, or lists the candidates, or, if they are
// too many, leaves the face to search_widely(). Returns the ball before the face if it is known.
__device__ inline std::uint32_t end_search(const Front& front, const SearchSpace& space, bool ends,
                                           FaceRef face, const BestBalls& best) {
  const int lane = static_cast<int>(threadIdx.x & 31), sub = lane % kFan, group = lane - sub;
  const auto of_group = [&](unsigned bits) { return bits >> group & 0xffu; };
  const float high = least_of_lanes(best.high);
  const auto counts = [&](float low) { return low <= high && low < Crossing<float>::kNever; };
  const bool first = ends && counts(best.low), second = ends && counts(best.second_low);
  const unsigned firsts = of_group(__ballot_sync(~0u, first)),
                 seconds = of_group(__ballot_sync(~0u, second)),
                 more = of_group(__ballot_sync(~0u, ends && counts(best.third_low)));
  const int all = __popc(firsts) + __popc(seconds);
  // If no ball is certainly in front, all that may be are candidates.
  const bool one = all == 1 && high < Crossing<float>::kNever, sure = all == 0 || one,
             lists = ends && !sure && all <= kMostCandidates && more == 0;
  std::uint32_t place = 0;
  if (lists && sub == 0) place = space.doubtful.add(face);
  place = __shfl_sync(~0u, place, group);
  const std::uint32_t only =
      __shfl_sync(~0u, best.slot, group + (firsts != 0 ? __ffs(static_cast<int>(firsts)) - 1 : 0));
  if (lists) {
    std::uint32_t* const to = space.candidates[place].slot;
    const unsigned before = (1u << sub) - 1;
    if (sub >= all) to[sub] = kHull;
    if (first) to[__popc(firsts & before)] = best.slot;
    if (second) to[__popc(firsts) + __popc(seconds & before)] = best.second;
  } else if (ends && sub == 0) {
    if (sure) {
      front.apex[face] = one ? only : kHull;
    } else {
      space.bounds[space.wide.add(face)] = high;
    }
  }
  return ends && one ? only : kUnsearched;
}

// Claims the other open faces of the tetrahedron of a face and the ball before it, so that they
// need not be searched. Every lane of the warp may call it; `apex` is that of its eight lanes.
__device__ inline void claim_others(const Front& front, const FaceBalls& balls,
                                    std::uint32_t apex) {
  const int sub = static_cast<int>(threadIdx.x) % kFan;
  if (!is_ball(apex) || sub > 3) return;
  const QuadAtFace made = quad_of(balls, apex);
  if (sub == made.corner) return;
  const FaceRef other = place_of(front.table, front.faces, face_of(made.quad, sub)).entry;
  if (other < kNoRoom) atomicCAS(&front.apex[other], kUnsearched, kClaimed);
}

}  // namespace alphascope::gpu
