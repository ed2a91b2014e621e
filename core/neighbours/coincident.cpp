// SPDX-License-Identifier: GPL-3.0-or-later
// Finds balls with equal centres by hash tables, in groups that fit the cache.
#include "core/neighbours/coincident.hpp"

#include <tbb/concurrent_vector.h>

#include <algorithm>
#include <cstdint>

#include "core/geometry/lattice_point.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

std::uint64_t centre_hash(const LatticePoint& p) {
  std::uint64_t h = static_cast<std::uint32_t>(p.x);
  h = (h ^ (static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.y)) << 24)) *
      0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(p.z)) * 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

// The balls in groups by the hash of their centres, ascending in each group. Balls with the same
// centre are in the same group. The table of a group with some thousand balls fits the cache.
class HashGroups {
 public:
  HashGroups(const std::vector<LatticePoint>& centres, const CancelToken& cancel)
      : centres_(centres), runs_((centres.size() + kRun - 1) / kRun) {
    while (bits_ < kMostBits && kGroup << bits_ < centres.size()) ++bits_;
    places_.resize(runs_ * count());
    members_.resize(centres.size());
    for_runs(cancel, [&](BallIndex, std::size_t& place) { ++place; });
    start_groups();
    for_runs(cancel, [&](BallIndex i, std::size_t& place) { members_[place++] = i; });
  }

  std::size_t count() const { return std::size_t{1} << bits_; }
  // The end of a group in members_. When all balls are placed, the last run's counter is the place
  // behind the group's last ball.
  std::size_t end(std::size_t group) const { return places_[(runs_ - 1) * count() + group]; }
  std::size_t begin(std::size_t group) const { return group == 0 ? 0 : end(group - 1); }
  BallIndex member(std::size_t at) const { return members_[at]; }

 private:
  static constexpr std::size_t kRun = std::size_t{1} << 16, kGroup = std::size_t{1} << 13;
  static constexpr int kMostBits = 12;  // at most half a byte of places_ for each ball

  // Divides the balls into runs of kRun, which run in parallel. Calls visit(ball, place) for each
  // ball, where `place` is the counter of the ball's run and group. Throws Cancelled.
  template <class Visit>
  void for_runs(const CancelToken& cancel, const Visit& visit) {
    parallel_each(0, runs_, [&](std::size_t run) {
      if (cancel.cancelled()) return;
      const std::size_t end = std::min(centres_.size(), (run + 1) * kRun);
      for (std::size_t i = run * kRun; i < end; ++i) {
        // Groups use the upper bits of the hash, because the tables use the lower ones.
        const std::size_t group = bits_ == 0 ? 0 : centre_hash(centres_[i]) >> (64 - bits_);
        visit(static_cast<BallIndex>(i), places_[run * count() + group]);
      }
    });
    cancel.throw_if_cancelled();
  }
  // Turns each counter from a number of balls into the place of the first of these balls in
  // members_.
  void start_groups() {
    std::size_t sum = 0;
    for (std::size_t group = 0; group < count(); ++group) {
      for (std::size_t run = 0; run < runs_; ++run) {
        std::size_t& place = places_[run * count() + group];
        const std::size_t own = place;
        place = sum;
        sum += own;
      }
    }
  }

  const std::vector<LatticePoint>& centres_;
  const std::size_t runs_;
  int bits_ = 0;  // bits of the hash that choose the group
  std::vector<std::size_t> places_;
  std::vector<BallIndex> members_;
};

// Calls hide(ball) for the hidden balls of a group. The hash table has open addressing with the
// centre as its key. Each entry holds the visible ball at that centre.
template <class Hide>
void hide_in_group(const BallSet& balls, const HashGroups& groups, std::size_t group,
                   const Hide& hide) {
  constexpr BallIndex kEmpty = ~BallIndex{0};
  std::size_t capacity = 16;
  while (capacity < 2 * (groups.end(group) - groups.begin(group))) capacity *= 2;
  std::vector<BallIndex> table(capacity, kEmpty);
  for (std::size_t m = groups.begin(group); m < groups.end(group); ++m) {
    const BallIndex i = groups.member(m);
    std::size_t at = centre_hash(balls.centres[i]) & (capacity - 1);
    while (table[at] != kEmpty && balls.centres[table[at]] != balls.centres[i]) {
      at = (at + 1) & (capacity - 1);
    }
    if (table[at] == kEmpty) {
      table[at] = i;
      continue;
    }
    const bool wins = balls.radii[i] > balls.radii[table[at]];
    hide(wins ? table[at] : i);
    if (wins) table[at] = i;
  }
}

}  // namespace

std::vector<bool> coincident_hidden(const BallSet& balls, const CancelToken& cancel) {
  if (balls.size() == 0) return {};
  const HashGroups groups(balls.centres, cancel);
  tbb::concurrent_vector<BallIndex> found;
  parallel_each(0, groups.count(), [&](std::size_t group) {
    if (cancel.cancelled()) return;
    hide_in_group(balls, groups, group, [&](BallIndex i) { found.push_back(i); });
  });
  cancel.throw_if_cancelled();
  if (found.empty()) return {};
  std::vector<bool> hidden(balls.size(), false);
  for (const BallIndex i : found) hidden[i] = true;
  return hidden;
}

}  // namespace alphascope
