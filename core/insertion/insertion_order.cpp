// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts balls by round and by place on a Hilbert curve.
#include "core/insertion/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

constexpr int kCurveBits = 10;  // for each axis

// The place on a Hilbert curve of a cell of a grid with 2^kCurveBits cells to an axis
// (J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707, 2004).
std::uint32_t curve_place(std::array<std::uint32_t, 3> x) {
  for (std::uint32_t bit = 1u << (kCurveBits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t& v : x) {
      if ((v & bit) != 0) {
        x[0] ^= lower;
      } else {
        const std::uint32_t swapped = (x[0] ^ v) & lower;
        x[0] ^= swapped;
        v ^= swapped;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t turned = 0;
  for (std::uint32_t bit = 1u << (kCurveBits - 1); bit > 1; bit >>= 1) {
    if ((x[2] & bit) != 0) turned ^= bit - 1;
  }
  std::uint32_t place = 0;
  for (int bit = kCurveBits - 1; bit >= 0; --bit) {
    for (const std::uint32_t v : x) place = place << 1 | (((v ^ turned) >> bit) & 1);
  }
  return place;
}

// A number without order, from the index of a ball.
std::uint64_t scattered(std::uint64_t index) {
  std::uint64_t h = (index + 1) * 0x9e3779b97f4a7c15u;
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 27) * 0x94d049bb133111ebu;
  return h ^ h >> 31;
}

struct Placed {
  std::uint32_t round, place;
  BallIndex ball;
  friend bool operator<(const Placed& a, const Placed& b) {
    if (a.round != b.round) return a.round < b.round;
    return a.place != b.place ? a.place < b.place : a.ball < b.ball;
  }
};

// Sorts by bucket, one for each round and stretch of the curve, and then each bucket.
class Buckets {
 public:
  Buckets(const ResultArray<Placed>& placed, std::uint32_t rounds, const CancelToken& cancel)
      : first_((std::size_t{rounds} << kStretchBits) + 1, 0), sorted_(placed.size()) {
    parallel_many(placed.size(), cancel,
                  [&](std::size_t n) { raise(first_[bucket_of(placed[n]) + 1]); });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    parallel_many(placed.size(), cancel,
                  [&](std::size_t n) { sorted_[raise(next[bucket_of(placed[n])])] = placed[n]; });
    parallel_many(next.size(), cancel, [&](std::size_t bucket) {
      std::sort(sorted_.begin() + first_[bucket], sorted_.begin() + first_[bucket + 1]);
    });
  }

  const ResultArray<Placed>& sorted() const { return sorted_; }
  std::size_t end(std::uint32_t round) const {
    return first_[(std::size_t{round} + 1) << kStretchBits];
  }

 private:
  static constexpr int kStretchBits = 12;
  static std::size_t bucket_of(const Placed& p) {
    return (std::size_t{p.round} << kStretchBits) + (p.place >> (3 * kCurveBits - kStretchBits));
  }
  // Returns the number before.
  static std::uint32_t raise(std::uint32_t& number) {
    return std::atomic_ref(number).fetch_add(1, std::memory_order_relaxed);
  }
  std::vector<std::uint32_t> first_;  // of each bucket
  ResultArray<Placed> sorted_;
};

}  // namespace

InsertionOrder insertion_order(const BallSet& balls, const std::vector<bool>& left_out,
                               const CancelToken& cancel) {
  constexpr std::size_t kFewest = 64;  // in the first round
  const std::size_t count = balls.size();
  InsertionOrder order;
  if (count == 0) return order;
  LatticePoint low = balls.centres[0], high = low;
  for (const LatticePoint& p : balls.centres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto width =
      static_cast<std::uint32_t>(std::max({high.x - low.x, high.y - low.y, high.z - low.z}));
  const int shift = std::max(0, static_cast<int>(std::bit_width(width)) - kCurveBits);
  std::uint32_t last_round = 0;
  while (kFewest << (3 * (last_round + 1)) <= count) ++last_round;

  ResultArray<Placed> placed(count);
  parallel_ranges(0, count, 1024, [&](std::size_t first, std::size_t end) {
    if (cancel.cancelled()) return;
    for (std::size_t i = first; i != end; ++i) {
      const LatticePoint& p = balls.centres[i];
      const std::uint32_t place = curve_place({static_cast<std::uint32_t>(p.x - low.x) >> shift,
                                               static_cast<std::uint32_t>(p.y - low.y) >> shift,
                                               static_cast<std::uint32_t>(p.z - low.z) >> shift});
      const auto early = static_cast<std::uint32_t>(std::countr_zero(scattered(i))) / 3;
      placed[i] = {last_round - std::min(early, last_round), place, static_cast<BallIndex>(i)};
    }
  });
  cancel.throw_if_cancelled();
  if (!left_out.empty()) std::erase_if(placed, [&](const Placed& p) { return left_out[p.ball]; });
  const Buckets buckets(placed, last_round + 1, cancel);
  for (std::uint32_t round = 0; round <= last_round; ++round)
    order.rounds.push_back(buckets.end(round));
  order.balls.resize(placed.size());
  parallel_many(placed.size(), cancel,
                [&](std::size_t n) { order.balls[n] = buckets.sorted()[n].ball; });
  return order;
}

}  // namespace alphascope
