// SPDX-License-Identifier: GPL-3.0-or-later
// Decides how blocks of a run use their shared memory, and how much memory the result gets. The
// decision follows from earlier runs of the same balls.
#pragma once

#include "gpu/dual_edge/block_margin.hpp"
#include "gpu/dual_edge/dual_edge_block.cuh"
#include "gpu/dual_edge/pipeline_state.cuh"

namespace alphascope::gpu {

using State = DualEdgePipeline::State;
using Need = State::Need;

inline std::uint32_t whole_words(double list) {
  return static_cast<std::uint32_t>(std::ceil(std::max(1.0, list) / 32)) * 32;
}

// Returns whether neighbours with covered discs are left out: from a mean of 20 found balls on. A
// set for which this was done keeps it down to 18, so that runs near the limit do not alternate.
inline bool is_culled(double mean_found, bool was_culled) {
  return mean_found >= (was_culled ? 18 : 20);
}

// The needs of blocks of `balls` balls, see BlockStatistics.
struct Demand {
  struct Spread {
    double mean, deviation;
  };
  int balls;
  bool cull;
  Spread found, list, entries, rows, triangles, listed, probed, kept;
};

inline Demand::Spread spread_of(const Measured& of) {
  if (of.number == 0) return {0, 0};
  const double number = static_cast<double>(of.number), mean = static_cast<double>(of.sum) / number;
  const double variance = static_cast<double>(of.squares) / number - mean * mean;
  return {mean, std::sqrt(std::max(0.0, variance))};
}
inline Demand measured(const BlockStatistics& met, int balls, bool cull) {
  return {balls,
          cull,
          spread_of(met.found),
          spread_of(met.list),
          spread_of(met.entries),
          spread_of(met.rows),
          spread_of(met.triangles),
          spread_of(met.listed),
          spread_of(met.probed),
          spread_of(met.kept)};
}
// Guesses the demand from the number of balls found alone, for a run that had no room to measure
// more. Culled lists of molecules have 10 balls plus a third of those found. A quarter of the pairs
// in a list meet.
inline Demand guessed(const Demand::Spread& found, bool cull, bool whole) {
  const double list = cull ? std::min(found.mean, 10 + 0.35 * found.mean) : found.mean;
  const int balls = kMaxBallsPerBlock;
  const auto of_block = [&](double mean, double deviation) {
    return Demand::Spread{balls * mean, balls * mean * deviation};
  };
  const double triangles = list * list / 8;
  return {balls,
          cull,
          found,
          {list, 0.3 * list},
          of_block(list, 0.15),
          of_block(list / 2, 0.2),
          of_block(triangles, 0.3),
          of_block(triangles / 2, 0.3),
          of_block(triangles / 3, 0.3),
          of_block(whole ? 15 : 6.5, 0.3)};
}
inline Demand larger(Demand a, const Demand& b) {
  const auto more = [](Demand::Spread& x, const Demand::Spread& y) {
    if (x.mean + 3 * x.deviation < y.mean + 3 * y.deviation) x = y;
  };
  const double balls = static_cast<double>(a.balls) / b.balls;
  const auto scaled = [&](const Demand::Spread& of) {
    return Demand::Spread{of.mean * balls, of.deviation * balls};
  };
  more(a.list, b.list);
  more(a.entries, scaled(b.entries));
  more(a.rows, scaled(b.rows));
  more(a.triangles, scaled(b.triangles));
  more(a.listed, scaled(b.listed));
  more(a.probed, scaled(b.probed));
  more(a.kept, scaled(b.kept));
  return a;
}

// Room for blocks of this many balls: the mean plus `margin` times three standard deviations (four
// or more for some). The deviation of a sum over fewer balls than were measured falls with the root
// of their number. That of a sum over more balls grows in proportion, because neighbours have
// similar surroundings. Balls that find no room go to kernel III.
inline BlockRoom room_for(int balls, const Demand& demand, double margin) {
  const double ratio = static_cast<double>(balls) / demand.balls;
  const auto most = [&](const Demand::Spread& of, double deviations) {
    return std::min(of.mean + deviations * margin * of.deviation, kMaxList - 3.0);
  };
  const auto sum = [&](const Demand::Spread& of) {
    const double room =
        of.mean * ratio + 3 * margin * of.deviation * std::max(ratio, std::sqrt(ratio));
    return static_cast<std::uint32_t>(std::min(room, 1e9)) + 16;
  };
  const std::uint32_t triangles = std::min<std::uint32_t>(sum(demand.triangles), kMaxTriangles - 1);
  // A multiple of 4. No list is longer: see kMaxList.
  const auto search = std::min(static_cast<int>(most(demand.found, 4) / 4 + 1), kMaxList / 4) * 4;
  return {static_cast<std::uint32_t>(search),
          whole_words(most(demand.list, 3)),
          sum(demand.entries),
          sum(demand.rows),
          triangles,
          std::min(sum({demand.listed.mean, 1.5 * demand.listed.deviation}), triangles),
          demand.cull ? sum(demand.probed) : 0,
          sum(demand.kept)};
}

inline std::size_t bytes_of(const BlockRoom& room, int balls, bool cull) {
  DualEdgeProblem p{};
  p.cull = cull;
  p.common.balls_per_block = balls;
  p.capacity = room;
  p.words = static_cast<int>(room.list / 32);
  lay_out(p);
  return p.layout.bytes;
}

// A score of how well blocks with this many balls and bytes use the device, fitted to times on an
// H200. With more work per block, its barriers cost less. With more warps, less time is lost in
// waiting for memory. With more rounds of blocks, the last round, which leaves a part of the device
// idle, costs less.
inline double use_of(const State& s, int balls, const Demand::Spread& found, std::size_t bytes) {
  constexpr double kEnough = 8, kBarriers = 65;
  // CUDA reserves 1 KB per block.
  const double shared = static_cast<double>(bytes + sizeof(BlockBalls) + 1024),
               blocks = std::clamp(std::floor(s.shared_per_multiprocessor / shared), 1.0, kEnough),
               warps = blocks * kBlockThreads / 32;
  const double rounds = static_cast<double>(s.n) / balls / (blocks * s.multiprocessors);
  return balls / (balls + kBarriers / std::max(1.0, found.mean)) * warps / (warps + 16) * rounds /
         (rounds + 0.5);
}

// Room of kernel III for a ball with these numbers.
inline BlockRoom enough_for(const BlockRoom& room, std::uint32_t found, std::uint32_t list,
                            std::uint32_t triangles, std::uint32_t kept) {
  const std::uint32_t words = std::max(room.list, whole_words(list));
  return {std::max(room.search, whole_words(found)), words, words, words,
          std::max(room.triangles, triangles),       0,     0,     std::max(room.kept, kept)};
}

// Sets the number of balls per block, and the room of a block. Keeps the present number unless
// another one is better by more than 3 %.
inline void choose_room(const State& s, Need& need, const Demand& demand) {
  need.cull = demand.cull;
  const int current = need.balls_per_block;
  double best = -1;
  // Eight half warps search at once. So fewer balls are used only if there is no room for eight.
  for (const int balls : {32, 24, 16, 8, 4, 2, 1}) {
    if (balls < 8 && best > 0) break;
    const BlockRoom room = room_for(balls, demand, need.margin);
    const std::size_t bytes = bytes_of(room, balls, demand.cull);
    const bool fits = bytes + sizeof(BlockBalls) <= static_cast<std::size_t>(s.shared_limit) &&
                      room.rows < kMaxRows;
    const double use = !fits              ? -0.5
                       : balls == current ? 1.03 * use_of(s, balls, demand.found, bytes)
                                          : use_of(s, balls, demand.found, bytes);
    if (use <= best) continue;
    best = use;
    need.balls_per_block = balls;
    need.block = room;
  }
}

// Adds room to the need of a lower alpha, for an alpha not much above: more simplices here.
// with_headroom() does so for longer lists in kernel III.
inline void add_headroom(Need& need) {
  const auto more = [](std::size_t value) { return value + value / 4 + 64; };
  for (std::size_t& count : need.counts.of) count = more(count);
  need.candidates = more(need.candidates);
}
inline BlockRoom with_headroom(const BlockRoom& ball, const BlockRoom& longest) {
  const auto more = [](std::uint32_t value) { return value + value / 4 + 8; };
  return enough_for(ball, more(longest.search), more(longest.list), more(longest.triangles),
                    more(longest.kept));
}

// The need of this alpha, or of the nearest one above: a lower alpha never needs more. Without any,
// that of the nearest one below, to which the caller adds room. Without any run yet, a guess.
inline Need first_need(const State& s, const LatticeAlpha& alpha, bool whole) {
  const Need* best = nullptr;
  const auto better = [&](const Need& n) {
    if (n.whole != whole) return false;
    if (best == nullptr) return true;
    const bool enough = n.alpha >= alpha, best_enough = best->alpha >= alpha;
    return enough != best_enough ? enough : enough ? n.alpha < best->alpha : n.alpha > best->alpha;
  };
  for (const Need& n : s.needs) {
    if (better(n)) best = &n;
  }
  if (best != nullptr) {
    Need need = *best;
    need.counted = best->alpha == alpha;
    return need;
  }
  // A guess for a molecule at a small alpha. The run itself finds the true need.
  Need need{};
  need.alpha = alpha;
  need.whole = whole;
  need.ball = {64, 64, 64, 64, 1024, 0, 0, 64};
  need.counts = {{s.n, 5 * s.n, 6 * s.n, s.n}};
  need.candidates = 8 * s.n;
  need.margin = kUsualMargin;
  choose_room(s, need, guessed({12, 3}, false, whole));
  return need;
}

// The number of chunks. Each chunk costs time for queueing and waiting, but all copies except that
// of the last chunk run beside other work. Fitted to times on an H200. The first run of a set takes
// a single chunk. Its number of simplices is only a guess, too much to pin memory for.
inline int chunk_count(const State& s, const Need& need, std::size_t bytes) {
  if (s.chunks > 0) return std::min(s.chunks, kMaxChunks);
  if (need.totals.empty()) return 1;
  const double megabytes = static_cast<double>(bytes) / 1e6;
  const double best = need.whole ? std::sqrt(megabytes / 2.5)
                                 : std::max(std::sqrt(megabytes / 0.55), (megabytes - 3) / 1.85);
  constexpr double kLeastBalls = 4096;
  const double most = static_cast<double>(s.n) / kLeastBalls;
  return std::clamp(static_cast<int>(std::min(best, most)), 1, kMaxChunks);
}

inline void remember(State& s, const Need& need) {
  auto& all = s.needs;
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [&](const Need& n) { return n.alpha == need.alpha && n.whole == need.whole; }),
      all.end());
  if (all.size() >= 64) all.erase(all.begin());
  all.push_back(need);
}

// As DualEdgeProblem::deferred_limit.
inline std::uint32_t deferred_limit(const State& s) {
  return static_cast<std::uint32_t>(std::max<std::size_t>(256, s.n / 100));
}

inline DualEdgeProblem make_problem(const State& s, const Problem& plan, const BlockRoom& room,
                                    int balls_per_block, bool cull) {
  DualEdgeProblem p{};
  p.cull = cull;
  p.common = plan;
  p.common.balls_per_block = balls_per_block;
  p.capacity = room;
  p.common.search_capacity = static_cast<int>(room.search);
  // At least some hundred blocks are sampled.
  p.common.sampled = std::clamp(static_cast<int>(s.n / balls_per_block / 128), 1, 64);
  p.words = static_cast<int>((room.list + 31) / 32);
  p.radius_scale = p.common.scale * p.common.scale;
  const double grown = std::sqrt(plan.alpha.plus(std::int64_t{s.max_radius} * s.max_radius));
  const double offset = 2 * (grown + plan.reach_slack) * 1.001 + 2;  // bounds every |d_x|
  p.small_lattice = offset < static_cast<double>(kSmallOffset) && s.max_radius < kSmallOffset;
  p.narrow = offset < 32768 && s.max_radius < 32768;  // |d|² < 2^30, and so are weights
  p.balls = s.balls.get();
  p.deferred_limit = deferred_limit(s);
  lay_out(p);
  return p;
}

}  // namespace alphascope::gpu
