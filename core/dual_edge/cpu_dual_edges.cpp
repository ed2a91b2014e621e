#include "core/dual_edge/cpu_dual_edges.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "core/complex/count_limits.hpp"
#include "core/dual_edge/ball_simplices.hpp"
#include "core/dual_edge/gather_faces.hpp"
#include "core/predicates/grown_balls.hpp"

namespace alphascope {
namespace {

// Balls per task: small enough to balance two threads on a small protein, large enough that a
// task's vectors amortise their growth.
constexpr std::size_t kBallsPerBlock = 128;

// Neighbour lists of the balls of one block, back to back.
struct NeighbourBlock {
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> end;  // per ball of the block: end of its list
};

// All slots whose grown ball may meet that of `slot`, ascending by ball index.
void find_neighbours(const UniformGrid& grid, std::uint32_t slot, std::vector<std::uint32_t>& found,
                     std::vector<std::uint32_t>& row_hits) {
  const std::int32_t x = grid.x[slot], y = grid.y[slot], z = grid.z[slot];
  const float reach = grid.reach[slot];
  const int cx = std::min(grid.cell_of(x, grid.origin.x), grid.nx - 1);
  const int cy = std::min(grid.cell_of(y, grid.origin.y), grid.ny - 1);
  const int cz = std::min(grid.cell_of(z, grid.origin.z), grid.nz - 1);
  const int z0 = std::max(cz - 1, 0), z1 = std::min(cz + 1, grid.nz - 1);
  const std::size_t first = found.size();
  for (int ax = std::max(cx - 1, 0); ax <= std::min(cx + 1, grid.nx - 1); ++ax) {
    for (int ay = std::max(cy - 1, 0); ay <= std::min(cy + 1, grid.ny - 1); ++ay) {
      const std::size_t row = (static_cast<std::size_t>(ax) * grid.ny + ay) * grid.nz;
      const std::uint32_t begin = grid.cell_start[row + z0], end = grid.cell_start[row + z1 + 1];
      if (row_hits.size() < end - begin) row_hits.resize(2 * (end - begin));
      std::uint32_t hits = 0;
      for (std::uint32_t t = begin; t < end; ++t) {
        row_hits[hits] = t;
        hits +=
            grown_balls_may_meet(grid.x[t] - x, grid.y[t] - y, grid.z[t] - z, reach, grid.reach[t]);
      }
      found.insert(found.end(), row_hits.begin(), row_hits.begin() + hits);
    }
  }
  found.erase(std::find(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(), slot));
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
            [&](std::uint32_t a, std::uint32_t b) { return grid.ball[a] < grid.ball[b]; });
}

// Where the simplices of one ball (as lowest vertex) start and end in its block's output.
struct BallRange {
  std::uint32_t edge[2], triangle[2], tetrahedron[2];
};

// Copies one dimension from block outputs to its place in the result; `position` is per ball.
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
  // Tetrahedra have no coface: all of K_alpha's are interior.
  list.classes.assign(with_values ? size : 0, SimplexClass::interior);
}

}  // namespace

NeighbourMoments sample_neighbours(const UniformGrid& grid, std::size_t samples) {
  NeighbourMoments moments;
  if (grid.size() == 0) return moments;
  const std::size_t step = std::max<std::size_t>(1, grid.size() / samples);
  std::vector<std::uint32_t> found, row_hits;
  double count = 0;
  for (std::size_t slot = step / 2; slot < grid.size(); slot += step) {
    found.clear();
    find_neighbours(grid, static_cast<std::uint32_t>(slot), found, row_hits);
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
  const std::size_t block_count = (grid.size() + kBallsPerBlock - 1) / kBallsPerBlock;
  const auto block_slots = [&](std::size_t b) {
    return std::pair{b * kBallsPerBlock, std::min(grid.size(), (b + 1) * kBallsPerBlock)};
  };
  const bool whole = !complex.tetrahedra_only;

  // Numbers within a block are of 32 bits.
  const auto require_block = [](std::size_t count) {
    require_at_most(count, kMostIndices, "neighbours or simplices of some balls");
  };

  // Kernel I: neighbours.
  std::vector<NeighbourBlock> neighbours(block_count);
  tbb::enumerable_thread_specific<std::vector<std::uint32_t>> row_hits;
  std::atomic<std::size_t> blocks_done{0};
  tbb::parallel_for(std::size_t{0}, block_count, [&](std::size_t b) {
    if (context.cancel.cancelled()) return;
    const auto [begin, end] = block_slots(b);
    for (std::size_t slot = begin; slot < end; ++slot) {
      find_neighbours(grid, static_cast<std::uint32_t>(slot), neighbours[b].slots,
                      row_hits.local());
      require_block(neighbours[b].slots.size());
      neighbours[b].end.push_back(static_cast<std::uint32_t>(neighbours[b].slots.size()));
    }
  });
  context.cancel.throw_if_cancelled();
  timer.lap(stage::kCandidates);

  // Kernels II and III: dual edges; the exact ones are redone where they stand, and timed.
  std::vector<BlockOutput> outputs(block_count);
  std::vector<BallRange> ranges(grid.size());
  std::vector<VertexState> states(whole ? balls.size() : 0, VertexState::absent);
  tbb::enumerable_thread_specific<std::unique_ptr<BallSimplices>> workers([&] {
    return std::make_unique<BallSimplices>(balls, grid, complex.alpha_on_lattice, whole);
  });
  tbb::parallel_for(std::size_t{0}, block_count, [&](std::size_t b) {
    if (context.cancel.cancelled()) return;
    BallSimplices& worker = *workers.local();
    BlockOutput& out = outputs[b];
    const auto [begin, end] = block_slots(b);
    std::uint32_t list_begin = 0;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const std::uint32_t list_end = neighbours[b].end[slot - begin];
      BallRange& range = ranges[slot];
      range.edge[0] = out.edges.size();
      range.triangle[0] = out.triangles.size();
      range.tetrahedron[0] = out.tetrahedra.size();
      const VertexState state =
          worker.process(static_cast<std::uint32_t>(slot),
                         {neighbours[b].slots.data() + list_begin, list_end - list_begin}, out);
      if (whole) states[grid.ball[slot]] = state;
      for (const std::size_t count : {out.edges.simplices.size(), out.triangles.simplices.size(),
                                      out.tetrahedra.simplices.size()}) {
        require_block(count);
      }
      range.edge[1] = out.edges.size();
      range.triangle[1] = out.triangles.size();
      range.tetrahedron[1] = out.tetrahedra.size();
      list_begin = list_end;
    }
    neighbours[b] = {};
    out.edges.shrink();
    out.triangles.shrink();
    out.tetrahedra.shrink();
    const std::size_t done = blocks_done.fetch_add(1, std::memory_order_relaxed) + 1;
    if (done % 64 == 0)
      context.report(stage::kFilteredValidity,
                     static_cast<double>(done) / static_cast<double>(block_count));
  });
  context.cancel.throw_if_cancelled();
  DualEdgeStatistics statistics;
  double exact_milliseconds = 0;
  std::size_t worker_count = 0;
  for (const auto& worker : workers) {
    statistics.dual_edges += worker->dual_edges();
    statistics.exact += worker->exact_dual_edges();
    exact_milliseconds += worker->exact_milliseconds();
    ++worker_count;
  }
  timer.lap_split(stage::kFilteredValidity, stage::kExactValidity,
                  worker_count == 0 ? 0 : exact_milliseconds / static_cast<double>(worker_count));

  // Prefix sum over the balls in index order gives every simplex its place: lexicographic order.
  struct Place {
    std::size_t triangle = 0, tetrahedron = 0;
  };
  std::vector<Place> places(balls.size() + 1);
  std::vector<EdgeRange> edges(whole ? balls.size() : 0);
  for (std::size_t slot = 0; slot < grid.size(); ++slot) {
    const BallRange& r = ranges[slot];
    Place& p = places[grid.ball[slot] + 1];
    p.triangle = r.triangle[1] - r.triangle[0];
    p.tetrahedron = r.tetrahedron[1] - r.tetrahedron[0];
    if (whole)
      edges[grid.ball[slot]] = {&outputs[slot / kBallsPerBlock].edges, r.edge[0], r.edge[1]};
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    places[i + 1].triangle += places[i].triangle;
    places[i + 1].tetrahedron += places[i].tetrahedron;
  }
  resize(complex.triangles, places.back().triangle, whole);
  resize(complex.tetrahedra, places.back().tetrahedron, whole);
  tbb::parallel_for(std::size_t{0}, block_count, [&](std::size_t b) {
    const auto [begin, end] = block_slots(b);
    for (std::size_t slot = begin; slot < end; ++slot) {
      const BallRange& r = ranges[slot];
      const Place& to = places[grid.ball[slot]];
      place(outputs[b].triangles, r.triangle[0], r.triangle[1], to.triangle, complex.triangles);
      place(outputs[b].tetrahedra, r.tetrahedron[0], r.tetrahedron[1], to.tetrahedron,
            complex.tetrahedra);
    }
    outputs[b].triangles = {};
    outputs[b].tetrahedra = {};
  });
  if (whole) {
    gather_edges(edges, complex);
    gather_vertices(balls, states, complex);
  }
  timer.lap(stage::kPrefixSum);
  return statistics;
}

}  // namespace alphascope
