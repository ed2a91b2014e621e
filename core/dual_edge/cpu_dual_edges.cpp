// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels I to III of the dual-edge engine on the CPU, over blocks of balls, and the prefix sum
// that orders the simplices.
#include "core/dual_edge/cpu_dual_edges.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>

#include "core/complex/count_limits.hpp"
#include "core/dual_edge/ball_simplices.hpp"
#include "core/dual_edge/gather_faces.hpp"
#include "core/neighbours/meeting_slots.hpp"
#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Balls per task. Blocks are small enough to balance two threads on a small protein, and large
// enough to amortise the growth of a task's vectors.
constexpr std::size_t kBallsPerBlock = 128;
// Neighbours a ball for which a block has room at first.
constexpr std::size_t kLikelyNeighbours = 8;

// Neighbour lists of the balls of one block, one after the other.
struct NeighbourBlock {
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> end;  // for each ball of the block: end of its list in `slots`
};

// For each dimension: an index into the simplices of a block's output, or their number.
struct BlockPlace {
  std::uint32_t edge, triangle, tetrahedron;
};

// Throws where a count does not fit the 32-bit indices within a block.
void require_block(std::size_t count) {
  require_at_most(count, kMostIndices, "neighbours or simplices of some balls");
}

BlockPlace end_of(const BlockOutput& out) {
  require_block(out.edges.simplices.size());
  require_block(out.triangles.simplices.size());
  require_block(out.tetrahedra.simplices.size());
  return {out.edges.size(), out.triangles.size(), out.tetrahedra.size()};
}

// The range of the simplices of one ball (as lowest vertex) in its block's output.
struct BallRange {
  BlockPlace begin, end;
};

// Copies the simplices begin to end - 1 of a block to index `to` of `list`.
template <int N>
void place(const SimplexBuffer<N>& from, std::size_t begin, std::size_t end, std::size_t to,
           SimplexList<N>& list) {
  std::copy(from.simplices.begin() + begin, from.simplices.begin() + end,
            list.simplices.begin() + to);
  if (list.alpha_values.empty()) return;
  std::copy(from.values.begin() + begin, from.values.begin() + end, list.alpha_values.begin() + to);
  for (std::size_t s = begin; s < end && !from.states.empty(); ++s) {
    list.classes[to + (s - begin)] = static_cast<SimplexClass>(from.states[s]);
  }
}

template <int N>
void resize(SimplexList<N>& list, std::size_t size, bool with_values) {
  list.simplices.resize(size);
  list.alpha_values.resize(with_values ? size : 0);
  // Tetrahedra have no cofaces, so all that are in K_alpha are interior.
  list.classes.assign(with_values ? size : 0, SimplexClass::interior);
}

// One run over all balls, one kernel after the other. Blocks of balls run in parallel.
class DualEdgeRun {
 public:
  DualEdgeRun(const BallSet& balls, const UniformGrid& grid, const RunContext& context,
              AlphaComplex& complex)
      : balls_(balls),
        grid_(grid),
        context_(context),
        complex_(complex),
        whole_(!complex.tetrahedra_only),
        block_count_((grid.size() + kBallsPerBlock - 1) / kBallsPerBlock),
        neighbours_(block_count_),
        outputs_(block_count_),
        ranges_(grid.size()),
        states_(whole_ ? balls.size() : 0, VertexState::absent),
        workers_([this] {
          return std::make_unique<BallSimplices>(balls_, grid_, complex_.alpha_on_lattice, whole_);
        }) {}

  // Kernel I: finds the neighbours of each ball.
  void find_candidates();
  // Kernels II and III: dual edges. A triangle that the filter leaves open is decided exactly at
  // once, and that time is measured.
  void clip_dual_edges();
  // Copies the simplices to their places in the result, and completes edges and vertices from their
  // cofaces.
  void order();

  DualEdgeStatistics statistics() const;
  // Time in exact arithmetic, ms: the mean over the threads.
  double exact_milliseconds() const;

 private:
  // Calls body(block, its first slot, the end of its slots) for all blocks, in parallel. Throws
  // Cancelled.
  template <class Body>
  void for_blocks(const Body& body) {
    parallel_each(0, block_count_, [&](std::size_t b) {
      if (context_.cancel.cancelled()) return;
      body(b, b * kBallsPerBlock, std::min(grid_.size(), (b + 1) * kBallsPerBlock));
    });
    context_.cancel.throw_if_cancelled();
  }
  void clip_block(std::size_t block, std::size_t begin, std::size_t end);
  void report_block();
  std::vector<EdgeRange> edge_ranges();

  const BallSet& balls_;
  const UniformGrid& grid_;
  const RunContext& context_;
  AlphaComplex& complex_;
  const bool whole_;
  const std::size_t block_count_;
  std::vector<NeighbourBlock> neighbours_;
  std::vector<BlockOutput> outputs_;
  std::vector<BallRange> ranges_;    // per slot
  std::vector<VertexState> states_;  // per ball
  tbb::enumerable_thread_specific<std::unique_ptr<BallSimplices>> workers_;
  std::atomic<std::size_t> blocks_done_{0};
};

void DualEdgeRun::find_candidates() {
  tbb::enumerable_thread_specific<std::vector<std::uint32_t>> scratch;
  for_blocks([&](std::size_t b, std::size_t begin, std::size_t end) {
    NeighbourBlock& found = neighbours_[b];
    found.end.reserve(end - begin);
    found.slots.reserve(kLikelyNeighbours * (end - begin));
    for (std::size_t slot = begin; slot < end; ++slot) {
      find_neighbours(grid_, static_cast<std::uint32_t>(slot), found.slots, scratch.local());
      require_block(found.slots.size());
      found.end.push_back(static_cast<std::uint32_t>(found.slots.size()));
    }
  });
}

void DualEdgeRun::clip_dual_edges() {
  for_blocks([&](std::size_t b, std::size_t begin, std::size_t end) {
    clip_block(b, begin, end);
    report_block();
  });
}

void DualEdgeRun::clip_block(std::size_t block, std::size_t begin, std::size_t end) {
  BallSimplices& worker = *workers_.local();
  const NeighbourBlock& lists = neighbours_[block];
  BlockOutput& out = outputs_[block];
  std::uint32_t list_begin = 0;
  for (std::size_t slot = begin; slot < end; ++slot) {
    const std::uint32_t list_end = lists.end[slot - begin];
    ranges_[slot].begin = end_of(out);
    const VertexState state =
        worker.process(static_cast<std::uint32_t>(slot),
                       {lists.slots.data() + list_begin, list_end - list_begin}, out);
    if (whole_) states_[grid_.ball[slot]] = state;
    ranges_[slot].end = end_of(out);
    list_begin = list_end;
  }
  neighbours_[block] = {};
  out.edges.shrink();
  out.triangles.shrink();
  out.tetrahedra.shrink();
}

void DualEdgeRun::report_block() {
  const std::size_t done = blocks_done_.fetch_add(1, std::memory_order_relaxed) + 1;
  if (done % 64 != 0) return;
  context_.report(stage::kFilteredValidity,
                  static_cast<double>(done) / static_cast<double>(block_count_));
}

DualEdgeStatistics DualEdgeRun::statistics() const {
  DualEdgeStatistics all;
  for (const auto& worker : workers_) {
    all.dual_edges += worker->dual_edges();
    all.exact += worker->exact_dual_edges();
  }
  return all;
}

double DualEdgeRun::exact_milliseconds() const {
  double all = 0;
  for (const auto& worker : workers_) all += worker->exact_milliseconds();
  return workers_.empty() ? 0 : all / static_cast<double>(workers_.size());
}

// A prefix sum over the balls in the order of their indices gives every simplex its place, in
// lexicographic order.
void DualEdgeRun::order() {
  struct Place {
    std::size_t triangle = 0, tetrahedron = 0;
  };
  std::vector<Place> places(balls_.size() + 1);
  for (std::size_t slot = 0; slot < grid_.size(); ++slot) {
    const auto& [begin, end] = ranges_[slot];
    places[grid_.ball[slot] + 1] = {end.triangle - begin.triangle,
                                    end.tetrahedron - begin.tetrahedron};
  }
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    places[i + 1].triangle += places[i].triangle;
    places[i + 1].tetrahedron += places[i].tetrahedron;
  }
  resize(complex_.triangles, places.back().triangle, whole_);
  resize(complex_.tetrahedra, places.back().tetrahedron, whole_);
  for_blocks([&](std::size_t b, std::size_t first, std::size_t last) {
    BlockOutput& out = outputs_[b];
    for (std::size_t slot = first; slot < last; ++slot) {
      const auto& [begin, end] = ranges_[slot];
      const Place& to = places[grid_.ball[slot]];
      place(out.triangles, begin.triangle, end.triangle, to.triangle, complex_.triangles);
      place(out.tetrahedra, begin.tetrahedron, end.tetrahedron, to.tetrahedron,
            complex_.tetrahedra);
    }
    out.triangles = {};
    out.tetrahedra = {};
  });
  if (!whole_) return;
  gather_edges(edge_ranges(), complex_);
  gather_vertices(balls_, states_, complex_);
}

std::vector<EdgeRange> DualEdgeRun::edge_ranges() {
  std::vector<EdgeRange> ranges(balls_.size());
  for (std::size_t slot = 0; slot < grid_.size(); ++slot) {
    const auto& [begin, end] = ranges_[slot];
    ranges[grid_.ball[slot]] = {&outputs_[slot / kBallsPerBlock].edges, begin.edge, end.edge};
  }
  return ranges;
}

}  // namespace

void find_neighbours(const UniformGrid& grid, std::uint32_t slot, std::vector<std::uint32_t>& found,
                     std::vector<std::uint32_t>& scratch) {
  const GrownBall ball{grid.x[slot], grid.y[slot], grid.z[slot], grid.reach[slot]};
  std::array<SlotRange, 9> ranges;
  std::size_t rows = 0, most = 0;
  grid.for_rows_around(grid.cell_at({ball.x, ball.y, ball.z}),
                       [&](std::uint32_t begin, std::uint32_t end) {
                         ranges[rows++] = {begin, end};
                         most += end - begin;
                       });
  most += kVectorRoom;
  if (scratch.size() < 2 * most) scratch.resize(4 * most);
  std::uint32_t *hits = scratch.data(), *keys = hits + most;
  const std::size_t count =
      find_meeting({grid.x.data(), grid.y.data(), grid.z.data(), grid.reach.data()},
                   {ranges.data(), rows}, ball, slot, hits);
  for (std::size_t h = 0; h < count; ++h) keys[h] = grid.ball[hits[h]];
  found.resize(found.size() + count);
  sort_by_key({keys, count}, hits, found.data() + found.size() - count);
}

NeighbourMoments sample_neighbours(const UniformGrid& grid, std::size_t samples) {
  NeighbourMoments moments;
  if (grid.size() == 0) return moments;
  const std::size_t step = std::max<std::size_t>(1, grid.size() / samples);
  std::vector<std::uint32_t> found, scratch;
  double count = 0;
  for (std::size_t slot = step / 2; slot < grid.size(); slot += step) {
    found.clear();
    find_neighbours(grid, static_cast<std::uint32_t>(slot), found, scratch);
    const auto m = static_cast<double>(found.size());
    moments.mean += m;
    moments.mean_square += m * m;
    count += 1;
  }
  moments.mean /= count;
  moments.mean_square /= count;
  return moments;
}

DualEdgeStatistics compute_by_dual_edges(const BallSet& balls, const UniformGrid& grid,
                                         const RunContext& context, StageTimer& timer,
                                         AlphaComplex& complex) {
  DualEdgeRun run(balls, grid, context, complex);
  run.find_candidates();
  timer.lap(stage::kCandidates);
  run.clip_dual_edges();
  timer.lap_split(stage::kFilteredValidity, stage::kExactValidity, run.exact_milliseconds());
  run.order();
  timer.lap(stage::kPrefixSum);
  return run.statistics();
}

}  // namespace alphascope
