// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts round after round. A large round is shared out: space is cut into parts, and each part
// gets a thread. Balls whose cells reach into another part are put off, and space is cut anew. The
// rest is inserted on one thread.
#include "core/insertion/insertion.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

#include "core/complex/count_limits.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/insertion/inserter.hpp"
#include "core/insertion/insertion_order.hpp"
#include "core/insertion/order_tetrahedra.hpp"
#include "core/insertion/parts.hpp"
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
        store_(8 * order.balls.size() + 4096) {
    parallel_ranges(0, balls_.size(), 4096, [&](std::size_t first, std::size_t end) {
      for (std::size_t n = first; n != end; ++n) {
        const BallIndex i = order_.balls[n];
        const LatticePoint& p = balls.centres[i];
        balls_[n] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z),
                     static_cast<double>(balls.weight(i))};
      }
    });
  }

  // `first`: places in the order of four balls that are not in a plane.
  void insert_all(const std::array<std::uint32_t, 4>& first) {
    inserters_.push_back(std::make_unique<Inserter>(balls_, store_));
    last_ = inserters_[0]->begin(first);
    std::size_t begin = 0;
    for (const std::size_t end : order_.rounds) {
      std::vector<std::uint32_t> round(end - begin);
      std::iota(round.begin(), round.end(), static_cast<std::uint32_t>(begin));
      std::erase_if(round, [&](std::uint32_t ball) {
        return std::find(first.begin(), first.end(), ball) != first.end();
      });
      insert_round(std::move(round), begin, end);
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
  // `left`: the balls of a round, places in the order between `begin` and `end`.
  void insert_round(std::vector<std::uint32_t> left, std::size_t begin, std::size_t end);
  // Returns the balls that are left.
  std::vector<std::uint32_t> insert_in_parts(std::vector<std::uint32_t> left, std::size_t parts,
                                             int turn, std::size_t end);
  struct Part {
    std::vector<std::uint32_t> balls;
    std::vector<std::uint32_t> starts;        // a cell near every kStride-th ball, or kInfinity
    std::uint32_t cell = Cell::kInfinity;     // one of the part, if known
    std::vector<std::uint32_t> put_off = {};  // balls
  };
  void find_starts(Inserter& inserter, Part& part);
  bool insert_part(Inserter& inserter, Part& part);
  void insert_one_by_one(const std::vector<std::uint32_t>& balls);
  // Counts balls that were inserted, and throws Cancelled.
  void went_on(std::size_t balls) {
    context_.cancel.throw_if_cancelled();
    const std::size_t done = done_.fetch_add(balls, std::memory_order_relaxed) + balls;
    if (std::this_thread::get_id() == caller_)
      context_.report(stage::kTriangulation,
                      static_cast<double>(done) / static_cast<double>(balls_.size()));
  }

  static constexpr std::size_t kStride = 32;
  static constexpr std::size_t kStep = 512;  // balls between looks at the cancel token

  const InsertionOrder& order_;
  const std::size_t threads_;
  const RunContext& context_;
  InsertionCounts& counts_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::vector<InsertedBall> balls_;  // in the order of insertion
  CellStore store_;
  std::vector<std::unique_ptr<Inserter>> inserters_;
  std::vector<std::uint8_t> part_of_;
  std::uint32_t last_ = 0;  // a cell that is used
  std::atomic<std::size_t> done_{0};
};

void InsertedRounds::insert_round(std::vector<std::uint32_t> left, std::size_t begin,
                                  std::size_t end) {
  // Of a part with fewer balls, old and new, most cells reach into other parts.
  constexpr std::size_t kFewestNew = 256, kFewestOld = 256;
  constexpr int kTurns = 12;
  for (int turn = 0; turn < kTurns; ++turn) {
    const std::size_t parts =
        std::min({threads_, left.size() / kFewestNew, begin / kFewestOld, Parts::kMost});
    if (parts < 2) break;
    const std::size_t before = left.size();
    left = insert_in_parts(std::move(left), parts, turn, end);
    if (left.size() > before - before / 8) break;
  }
  counts_.one_by_one += left.size();
  insert_one_by_one(left);
}

void InsertedRounds::insert_one_by_one(const std::vector<std::uint32_t>& balls) {
  Inserter& inserter = *inserters_[0];
  inserter.use_part(nullptr, 0);
  for (std::size_t n = 0; n < balls.size(); ++n) {
    if (n % kStep == 0) went_on(std::min(kStep, balls.size() - n));
    while (inserter.insert(balls[n], last_) == Insertion::no_room) store_.double_room();
  }
}

// While nobody changes cells.
void InsertedRounds::find_starts(Inserter& inserter, Part& part) {
  std::uint32_t cell = last_;
  for (std::size_t n = 0; n < part.balls.size(); n += kStride) {
    cell = inserter.cell_near(part.balls[n], cell);
    part.starts.push_back(inserter.is_of_part(cell) ? cell : Cell::kInfinity);
    if (part.cell == Cell::kInfinity) part.cell = part.starts.back();
  }
}

// Returns whether there was room for all cells.
bool InsertedRounds::insert_part(Inserter& inserter, Part& part) {
  if (part.cell == Cell::kInfinity) {
    part.put_off = part.balls;
    return true;
  }
  bool room = true;
  std::size_t before = 0;
  for (std::size_t n = 0; n < part.balls.size(); ++n) {
    if (n % kStep == 0) {
      const std::size_t inserted = n - part.put_off.size();
      went_on(inserted - before);
      before = inserted;
    }
    Insertion result = inserter.insert(part.balls[n], part.cell);
    // A cell of this part is replaced by others of it.
    if (const std::uint32_t start = part.starts[n / kStride];
        result == Insertion::out_of_reach && start != Cell::kInfinity && inserter.is_used(start)) {
      part.cell = start;
      result = inserter.insert(part.balls[n], part.cell);
    }
    if (result == Insertion::added || result == Insertion::hidden) continue;
    part.put_off.push_back(part.balls[n]);
    room = room && result != Insertion::no_room;
  }
  return room;
}

std::vector<std::uint32_t> InsertedRounds::insert_in_parts(std::vector<std::uint32_t> left,
                                                           std::size_t parts, int turn,
                                                           std::size_t end) {
  counts_.parts = std::max(counts_.parts, parts);
  while (inserters_.size() < parts)
    inserters_.push_back(std::make_unique<Inserter>(balls_, store_));
  const Parts space(parts, turn, balls_, left);
  part_of_.resize(balls_.size());
  parallel_ranges(0, end, 4096, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n != last; ++n) part_of_[n] = space.part_of(balls_[n]);
  });

  std::vector<Part> shares(parts);
  for (const std::uint32_t ball : left) shares[part_of_[ball]].balls.push_back(ball);
  parallel_each(0, parts, [&](std::size_t p) {
    inserters_[p]->use_part(part_of_.data(), static_cast<std::uint8_t>(p));
    find_starts(*inserters_[p], shares[p]);
  });
  context_.cancel.throw_if_cancelled();
  std::atomic<bool> full{false};
  parallel_each(0, parts, [&](std::size_t p) {
    if (!insert_part(*inserters_[p], shares[p])) full = true;
  });
  if (full) store_.double_room();
  left.clear();
  for (Part& part : shares) {
    if (part.cell != Cell::kInfinity) last_ = part.cell;
    left.insert(left.end(), part.put_off.begin(), part.put_off.end());
  }
  counts_.put_off += left.size();
  return left;
}

}  // namespace

std::optional<Triangulation> triangulate_by_insertion(const BallSet& balls, int threads,
                                                      const RunContext& context,
                                                      InsertionCounts* counts) {
  require_balls(balls.size());
  InsertionCounts unused;
  InsertionCounts& counted = counts != nullptr ? *counts : unused;
  counted.threads = threads;
  const InsertionOrder order =
      insertion_order(balls, coincident_hidden(balls, context.cancel), context.cancel);
  const std::vector<std::size_t> span = spanning_balls(balls, order.balls);
  if (span.size() < 4) return std::nullopt;
  std::array<std::uint32_t, 4> first;
  std::copy(span.begin(), span.end(), first.begin());
  InsertedRounds rounds(balls, order, threads, context, counted);
  rounds.insert_all(first);
  Triangulation result;
  result.dimension = 3;
  set_tetrahedra(balls, rounds, context.cancel, result);
  set_vertices(balls.size(), context.cancel, result);
  return result;
}

}  // namespace alphascope
