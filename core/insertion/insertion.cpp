// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts round after round. A large round is shared out among inserters, one for a thread. Balls
// that need what another inserter holds are put off to the next turn. The rest of a round is
// inserted on one thread.
#include "core/insertion/insertion.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/insertion/claims.hpp"
#include "core/insertion/inserter.hpp"
#include "core/insertion/insertion_order.hpp"
#include "core/insertion/order_tetrahedra.hpp"
#include "core/insertion/stretches.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/predicates/spanning_balls.hpp"
#include "core/run/parallel.hpp"
#include "core/run/stage_timer.hpp"

namespace alphascope {
namespace {

class InsertedRounds {
 public:
  InsertedRounds(const BallSet& balls, const InsertionOrder& order, int threads,
                 const RunContext& context, InsertionCounts& counts)
      : order_(order),
        threads_(static_cast<std::size_t>(threads)),
        context_(context),
        counts_(counts),
        balls_(order.balls.size()),
        store_(8 * order.balls.size() + 4096),
        claims_(order.balls.size()) {
    parallel_ranges(0, balls_.size(), 4096, [&](std::size_t first, std::size_t end) {
      for (std::size_t n = first; n != end; ++n) {
        const BallIndex i = order_.balls[n];
        const LatticePoint& p = balls.centres[i];
        balls_[n] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z),
                     static_cast<double>(balls.weight(i))};
      }
    });
  }

  // The first four balls are not in a plane.
  void insert_all() {
    inserters_.push_back(std::make_unique<Inserter>(balls_, store_));
    last_ = inserters_[0]->begin({0, 1, 2, 3});
    std::size_t begin = 4;
    for (const std::size_t end : order_.rounds) {
      if (end <= begin) continue;
      std::vector<std::uint32_t> round(end - begin);
      std::iota(round.begin(), round.end(), static_cast<std::uint32_t>(begin));
      insert_round(std::move(round), begin);
      begin = end;
    }
  }

  // As a source of set_tetrahedra().
  std::size_t slots() const { return store_.taken(); }
  bool has(std::size_t slot) const {
    const Cell& cell = store_.data()[slot];
    return cell.state == Cell::kUsed && !cell.at_infinity();
  }
  std::array<BallIndex, 4> balls(std::size_t slot) const {
    const std::uint32_t(&of)[4] = store_.data()[slot].ball;
    return {order_.balls[of[0]], order_.balls[of[1]], order_.balls[of[2]], order_.balls[of[3]]};
  }
  TetrahedronCorners corners(std::size_t slot) const {
    const Cell& cell = store_.data()[slot];
    TetrahedronCorners corners;
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = {order_.balls[cell.ball[k]], cell.across[k] / 4};
    return corners;
  }

 private:
  // `left`: the balls of a round, places in the order. All before `begin` are inserted.
  void insert_round(std::vector<std::uint32_t> left, std::size_t begin);
  // Returns the balls that are left.
  std::vector<std::uint32_t> insert_together(const std::vector<std::uint32_t>& left,
                                             std::size_t inserters);
  // Aligned, so that two threads do not write to one cache line.
  struct alignas(128) Share {
    std::uint32_t cell = 0;  // from which the inserter goes on
    bool has_begun = false;
    std::vector<std::uint32_t> put_off = {};  // balls
  };
  // Returns whether there was room for all cells.
  bool insert_share(const std::vector<std::uint32_t>& balls, Stretches& stretches, std::size_t own,
                    Share& share);
  void insert_one_by_one(const std::vector<std::uint32_t>& balls);
  // Counts balls that were inserted, and throws Cancelled.
  void went_on(std::size_t balls) {
    context_.cancel.throw_if_cancelled();
    const std::size_t done = done_.fetch_add(balls, std::memory_order_relaxed) + balls;
    if (std::this_thread::get_id() == caller_)
      context_.report(stage::kTriangulation,
                      static_cast<double>(done) / static_cast<double>(balls_.size()));
  }

  static constexpr std::size_t kStep = 512;  // balls between looks at the cancel token

  const InsertionOrder& order_;
  const std::size_t threads_;
  const RunContext& context_;
  InsertionCounts& counts_;
  const std::thread::id caller_ = std::this_thread::get_id();
  ResultArray<InsertedBall> balls_;  // in the order of insertion
  CellStore store_;
  Claims claims_;
  std::vector<std::unique_ptr<Inserter>> inserters_;
  std::uint32_t last_ = 0;  // a cell that is used
  std::atomic<std::size_t> done_{0};
};

void InsertedRounds::insert_round(std::vector<std::uint32_t> left, std::size_t begin) {
  // With fewer balls, old and new, inserters meet too often.
  constexpr std::size_t kFewestNew = 32, kFewestOld = 32;
  constexpr int kTurns = 12;
  const std::size_t end = begin + left.size();
  for (int turn = 0; turn < kTurns; ++turn) {
    const std::size_t before = left.size(),
                      inserters = std::min({threads_, before / kFewestNew,
                                            (end - before) / kFewestOld, Claims::kMostInserters});
    if (inserters < 2) break;
    left = insert_together(left, inserters);
    if (left.size() > before - before / 8) break;
  }
  counts_.one_by_one += left.size();
  insert_one_by_one(left);
}

void InsertedRounds::insert_one_by_one(const std::vector<std::uint32_t>& balls) {
  Inserter& inserter = *inserters_[0];
  for (std::size_t n = 0; n < balls.size(); ++n) {
    if (n % kStep == 0) went_on(std::min(kStep, balls.size() - n));
    while (inserter.insert(balls[n], last_) == Insertion::no_room) store_.double_room();
  }
}

std::vector<std::uint32_t> InsertedRounds::insert_together(const std::vector<std::uint32_t>& left,
                                                           std::size_t inserters) {
  counts_.inserters = std::max(counts_.inserters, inserters);
  const std::size_t there = inserters_.size();
  inserters_.resize(std::max(there, inserters));
  parallel_each(there, inserters_.size(),
                [&](std::size_t i) { inserters_[i] = std::make_unique<Inserter>(balls_, store_); });
  Stretches stretches(left.size(), inserters);
  std::vector<Share> shares(inserters);
  for (std::size_t i = 0; i < inserters; ++i) {
    last_ = inserters_[0]->cell_near(left[stretches.left(i).begin], last_);
    shares[i].cell = last_;
  }
  for (std::size_t i = 0; i < inserters; ++i) {
    shares[i].has_begun =
        inserters_[i]->begin_sharing(claims_, static_cast<std::uint8_t>(i + 1), shares[i].cell);
  }
  std::atomic<bool> full{false};
  parallel_each(0, inserters, [&](std::size_t i) {
    if (shares[i].has_begun && !insert_share(left, stretches, i, shares[i])) full = true;
  });
  std::vector<std::uint32_t> put_off;
  for (std::size_t i = 0; i < inserters; ++i) {
    inserters_[i]->end_sharing();
    if (shares[i].has_begun) last_ = shares[i].cell;
    put_off.insert(put_off.end(), shares[i].put_off.begin(), shares[i].put_off.end());
  }
  counts_.put_off += put_off.size();
  std::sort(put_off.begin(), put_off.end());  // along the curve
  if (full) store_.double_room();
  return put_off;
}

bool InsertedRounds::insert_share(const std::vector<std::uint32_t>& balls, Stretches& stretches,
                                  std::size_t own, Share& share) {
  constexpr std::uint32_t kAtOnce = 64;
  Inserter& inserter = *inserters_[own];
  bool room = true;
  while (true) {
    const Stretches::Range range = stretches.take(own, kAtOnce);
    if (range.empty()) break;
    const std::size_t before = share.put_off.size();
    for (std::uint32_t n = range.begin; n != range.end; ++n) {
      const Insertion result = inserter.insert(balls[n], share.cell);
      if (result == Insertion::added || result == Insertion::hidden) continue;
      share.put_off.push_back(balls[n]);
      room = room && result != Insertion::no_room;
    }
    went_on(range.end - range.begin - (share.put_off.size() - before));
  }
  inserter.release_all_but(share.cell);
  return room;
}

}  // namespace

std::optional<Triangulation> triangulate_by_insertion(const BallSet& balls, int threads,
                                                      const RunContext& context,
                                                      InsertionCounts* counts) {
  require_balls(balls.size());
  InsertionCounts unused;
  InsertionCounts& counted = counts != nullptr ? *counts : unused;
  counted.threads = threads;
  InsertionOrder order =
      insertion_order(balls, coincident_hidden(balls, context.cancel), context.cancel);
  const std::vector<std::size_t> span = spanning_balls(balls, order.balls);
  if (span.size() < 4) return std::nullopt;
  for (std::size_t n = 0; n < 4; ++n) std::swap(order.balls[n], order.balls[span[n]]);
  InsertedRounds rounds(balls, order, threads, context, counted);
  rounds.insert_all();
  Triangulation result;
  result.dimension = 3;
  set_tetrahedra(balls, rounds, context.cancel, result);
  set_vertices(balls.size(), context.cancel, result);
  return result;
}

}  // namespace alphascope
