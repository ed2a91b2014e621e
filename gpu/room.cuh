// How much shared memory the blocks of a run get for what, and the result for its simplices: from
// what earlier runs of the same balls met.
#pragma once

#include "gpu/dual_edge_block.cuh"
#include "gpu/pipeline_state.cuh"

namespace alphascope::gpu {

using State = FacetPipeline::State;
using Need = State::Need;

// Shared memory of a block: so that six share a multiprocessor with as much as Ampere's and
// Hopper's server parts have, four on others. 33 KB for long lists and 30 for short ones were the
// fastest of what was tried on an H200; nothing was tried on others.
inline std::size_t block_bytes(const State& s, double mean_found) {
  const std::size_t all = s.shared_per_multiprocessor, blocks = all >= 160 * 1024 ? 6 : 4;
  // What is static, what CUDA keeps for itself (1 KB), and rounding.
  const std::size_t share = all / blocks - sizeof(BlockBalls) - 2 * 1024;
  return mean_found >= 20 ? share : std::min<std::size_t>(share, 30 * 1024);
}
// Are covered discs looked for? From so many balls found for each on average.
inline bool is_culled(double mean_found) {
  return mean_found >= 20;
}

inline std::uint32_t whole_words(double list) {
  return static_cast<std::uint32_t>(std::ceil(std::max(1.0, list) / 32)) * 32;
}

// Of room_for().
inline constexpr double kLeastMore = 1, kMostMore = 3;

// What sampled blocks say about a ball: the balls that meet it, those in its list, triangles, and
// `kept` as in BlockRoom.
struct Means {
  struct Spread {
    double mean, deviation;
  };
  Spread found, list;
  double triangles, kept;
};

// Room for blocks of so many balls: for lists `margin` times three standard deviations above the
// mean, for their sums `more` times that. Neighbours have similar surroundings, so a block's sum
// varies more than sums of independent balls would; triangles vary like squares of lists. Balls
// that find no room go to kernel III.
inline BlockRoom room_for(int balls, const Means& means, double margin, double more) {
  const auto most = [&](const Means::Spread& of) {
    return whole_words(
        std::min(of.mean + 3 * margin * of.deviation, static_cast<double>(kMaxList - 1)));
  };
  const double list = means.list.mean, spread = 3 * margin * means.list.deviation;
  const double varied = more * spread / std::max(1.0, list) / std::sqrt(balls);
  const double lists = balls * list * (1.1 + varied),
               triangles = balls * means.triangles * (1.1 + 2 * varied);
  return {most(means.found),
          most(means.list),
          static_cast<std::uint32_t>(lists) + 32,
          static_cast<std::uint32_t>(lists / 2) + 32,
          std::min<std::uint32_t>(static_cast<std::uint32_t>(triangles) + 64, kMaxTriangles - 1),
          static_cast<std::uint32_t>(balls * means.kept * (1.1 + 2 * varied)) + 16};
}

inline std::size_t bytes_of(const BlockRoom& room, int balls) {
  DualEdgeProblem p{};
  p.common.balls_per_block = balls;
  p.capacity = room;
  p.words = static_cast<int>(room.list / 32);
  return block_memory_bytes(p);
}

// Balls a block when there are not enough to fill the machine.
inline std::size_t fair_share(const State& s) {
  return s.n / (static_cast<std::size_t>(s.multiprocessors) * 7);
}

// The largest run of balls whose block stays within its share of shared memory, of which it then
// takes all that helps.
inline void choose_room(const State& s, Need& need, const Means& means) {
  const std::size_t limit = block_bytes(s, means.found.mean), fair = fair_share(s);
  const auto room = [&](double more) {
    return room_for(need.balls_per_block, means, need.margin, more);
  };
  need.balls_per_block = kMaxBallsPerBlock;
  while (need.balls_per_block > 1 &&
         (bytes_of(room(kLeastMore), need.balls_per_block) > limit ||
          static_cast<std::size_t>(need.balls_per_block) > std::max<std::size_t>(fair, 4)))
    need.balls_per_block /= 2;
  need.block = room(kLeastMore);
  for (double more = kLeastMore + 0.1; more <= kMostMore; more += 0.1) {
    if (bytes_of(room(more), need.balls_per_block) > limit) break;
    need.block = room(more);
  }
}

// The need of this alpha, or of the nearest one above: less alpha never needs more.
inline Need first_need(const State& s, double alpha, bool whole) {
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
  // A molecule at small alpha; the run says what it really needs.
  Need need{alpha,   whole, 1, {},   {64, 64, 64, 64, 1024, 64}, {{s.n, 5 * s.n, 6 * s.n, s.n}},
            8 * s.n, 12,    1, false};
  choose_room(s, need, {{need.mean_found, 3}, {need.mean_found, 3}, 14, whole ? 5.0 : 1.5});
  return need;
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

inline DualEdgeProblem make_problem(const State& s, const Problem& plan, const BlockRoom& room,
                                    int balls_per_block) {
  DualEdgeProblem p{};
  p.common = plan;
  p.common.balls_per_block = balls_per_block;
  p.capacity = room;
  p.common.search_capacity = static_cast<int>(room.search);
  p.words = static_cast<int>((room.list + 31) / 32);
  p.radius_scale = p.common.scale * p.common.scale;
  const double grown = std::sqrt(static_cast<double>(s.max_radius) * s.max_radius + plan.alpha);
  const double offset = 2 * (grown + plan.reach_slack) * 1.001 + 2;  // bounds every |d_x|
  p.small_lattice = offset < static_cast<double>(kSmallOffset) && s.max_radius < kSmallOffset;
  p.balls = s.balls.get();
  p.deferred_limit = static_cast<std::uint32_t>(std::max<std::size_t>(256, s.n / 200));
  return p;
}

}  // namespace alphascope::gpu
