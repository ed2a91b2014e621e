// The tetrahedra of the alpha complex on the device: dual edges, then their lexicographic order.
#include "gpu/dual_edge_kernels.cuh"
#include "gpu/pipeline_state.cuh"

namespace alphascope::gpu {
namespace {

using State = FacetPipeline::State;

// Of shared memory a block: so that several share a multiprocessor's.
constexpr std::size_t kBlockBytes = 30 * 1024, kLargeBlockBytes = 36 * 1024;
// Mean number of neighbours from which on covered discs are looked for, and lists are long.
constexpr double kLongLists = 20;

std::uint32_t whole_words(double list) {
  return static_cast<std::uint32_t>(std::ceil(std::max(1.0, list) / 32)) * 32;
}

// What sampled blocks say about a ball's neighbours and triangles.
struct Means {
  double list, deviation, triangles, tetrahedra;
};

// Room for blocks of so many balls. Neighbours have similar surroundings, so a block's sum varies
// more than sums of independent balls would; triangles vary like squares of lists.
BlockRoom room_for(int balls, const Means& means, double margin) {
  const double varied = margin * 3 * means.deviation / std::max(1.0, means.list) / std::sqrt(balls);
  const double lists = balls * means.list * (1.1 + varied),
               triangles = balls * means.triangles * (1.1 + 2 * varied);
  const double list =
      std::min(means.list + 3 * margin * means.deviation, static_cast<double>(kMaxList - 1));
  return {whole_words(list), static_cast<std::uint32_t>(lists) + 32,
          static_cast<std::uint32_t>(lists / 2) + 32,
          std::min<std::uint32_t>(static_cast<std::uint32_t>(triangles) + 64, kMaxTriangles - 1),
          static_cast<std::uint32_t>(balls * means.tetrahedra * (1.1 + 2 * varied)) + 16};
}

// The largest run of balls whose block stays within its share of shared memory.
void choose_room(State::TetrahedraNeed& need, std::size_t fair, const Means& means) {
  const std::size_t limit = means.list >= kLongLists ? kLargeBlockBytes : kBlockBytes;
  for (int balls = kMaxBallsPerBlock; balls >= 1; balls /= 2) {
    DualEdgeProblem p{};
    p.common.balls_per_block = need.balls_per_block = balls;
    p.capacity = need.block = room_for(balls, means, need.margin);
    p.words = static_cast<int>(p.capacity.list / 32);
    if (block_memory_bytes(p) <= limit &&
        static_cast<std::size_t>(balls) <= std::max<std::size_t>(fair, 4))
      return;
  }
}

// Balls a block when there are not enough to fill the machine.
std::size_t fair_share(const State& s) {
  return s.n / (static_cast<std::size_t>(s.multiprocessors) * 7);
}

// The need of this alpha, or of the nearest one above: less alpha never needs more.
State::TetrahedraNeed first_need(const State& s, double alpha) {
  const State::TetrahedraNeed* best = nullptr;
  for (const auto& n : s.tetrahedra_needs) {
    if (n.alpha >= alpha && (best == nullptr || n.alpha < best->alpha)) best = &n;
  }
  if (best == nullptr) {
    for (const auto& n : s.tetrahedra_needs) {
      if (best == nullptr || n.alpha > best->alpha) best = &n;
    }
  }
  if (best != nullptr) return *best;
  // A molecule at small alpha; the run says what it really needs.
  State::TetrahedraNeed need{alpha, 1, {}, {64, 64, 64, 1024, 64}, s.n, 1};
  choose_room(need, fair_share(s), {12, 3, 14, 1.5});
  return need;
}

void remember(State& s, const State::TetrahedraNeed& need) {
  auto& all = s.tetrahedra_needs;
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const auto& n) { return n.alpha == need.alpha; }),
      all.end());
  if (all.size() >= 64) all.erase(all.begin());
  all.push_back(need);
}

DualEdgeProblem make_problem(const State& s, const Problem& plan, const BlockRoom& room,
                             int balls_per_block) {
  DualEdgeProblem p{};
  p.common = plan;
  p.common.balls_per_block = balls_per_block;
  p.capacity = room;
  p.common.list_capacity = static_cast<int>(room.list);
  p.words = static_cast<int>((room.list + 31) / 32);
  p.radius_scale = p.common.scale * p.common.scale;
  const double grown = std::sqrt(static_cast<double>(s.max_radius) * s.max_radius + plan.alpha);
  const double offset = 2 * (grown + plan.reach_slack) * 1.001 + 2;  // bounds every |d_x|
  p.small_lattice = offset < static_cast<double>(kSmallOffset) && s.max_radius < kSmallOffset;
  p.cull_facets = room.entries >= 1.3 * kLongLists * balls_per_block;
  p.first_cuts = p.cull_facets ? 8 : 0;
  p.balls = s.balls.get();
  p.deferred_limit = static_cast<std::uint32_t>(std::max<std::size_t>(256, s.n / 200));
  return p;
}

}  // namespace

PipelineResult State::run_tetrahedra(double alpha, const CancelToken& cancel, StageTimes* times) {
  PipelineResult result;
  result.fits = false;
  const std::optional<Problem> plan = this->plan(alpha);
  if (!plan) return result;
  DimensionBuffers& d = dimension[3];
  d.start.reserve(n);
  d.offset.reserve(n);

  EventTimer timer(stream, times);
  TetrahedraNeed need = first_need(*this, alpha);
  for (int attempt = 0; attempt < 12; ++attempt) {
    cancel.throw_if_cancelled();
    const std::size_t room = d.ordered.capacity();
    d.reserve(std::max<std::size_t>(need.tetrahedra, 1024), 4, false);
    // What is copied along below may be more than is found.
    if (d.ordered.capacity() != room) zero(d.ordered.get(), d.ordered.capacity() * 4);
    const DualEdgeProblem p = make_problem(*this, *plan, need.block, need.balls_per_block);
    DualEdgeProblem one = make_problem(*this, *plan, need.ball, 1);
    const std::size_t shared = block_memory_bytes(p), shared_one = block_memory_bytes(one);
    if (std::max(shared, shared_one) + sizeof(BlockBalls) >
            static_cast<std::size_t>(shared_limit) ||
        need.ball.list >= kMaxList || need.ball.triangles >= kMaxTriangles ||
        need.block.triangles >= kMaxTriangles || need.block.rows >= kMaxRows) {
      return result;
    }
    timer.restart();
    const SortedBalls sorted = sort_into_cells(p.common, timer);
    Counters* c = counters();
    std::uint32_t* count = zeroed.get() + kCounterWords + p.common.cell_count + 1;
    const DualEdgeOutput out{reinterpret_cast<uint4*>(d.vertices.get()),
                             static_cast<std::uint32_t>(d.simplices(4, false)),
                             &c->cursor[2],
                             d.start.get(),
                             count,
                             exact_list.get(),
                             &c->exact_count,
                             &c->blocks};
    const auto launch = [&](auto kernel, unsigned grid, const DualEdgeProblem& problem,
                            std::size_t bytes) {
      if (bytes > 40 * 1024) {
        check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                   static_cast<int>(bytes)),
              "preparing a kernel");
      }
      kernel<<<grid, kBlockThreads, bytes, stream>>>(problem, sorted, out);
      check(cudaGetLastError(), "starting a kernel");
    };
    const auto grid = static_cast<unsigned>((n + need.balls_per_block - 1) / need.balls_per_block);
    switch (p.words) {
      case 1:
        launch(dual_edges_filtered<1>, grid, p, shared);
        break;
      case 2:
        launch(dual_edges_filtered<2>, grid, p, shared);
        break;
      case 3:
        launch(dual_edges_filtered<3>, grid, p, shared);
        break;
      default:
        launch(dual_edges_filtered<0>, grid, p, shared);
    }
    timer.mark(stage::kCandidatesAndFiltered);
    launch(dual_edges_exact, static_cast<unsigned>(2 * multiprocessors), one, shared_one);
    timer.mark(stage::kExactValidity);
    scan(count, d.offset.get(), n);
    place<4><<<4 * multiprocessors, kThreads, 0, stream>>>(
        DeviceSimplices<4>{d.vertices.get(), nullptr, nullptr, out.capacity, out.cursor, out.start,
                           out.count},
        d.offset.get(), d.ordered.get(), nullptr, nullptr);
    check(cudaMemcpyAsync(host_counters.get(), c, sizeof(Counters), cudaMemcpyDeviceToHost, stream),
          "copying the counts");
    timer.mark(stage::kPrefixSum);
    // As many as last time come along at once; the rest, if any, when their number is known.
    const std::size_t expected = std::min<std::size_t>(need.tetrahedra, out.capacity);
    d.host_vertices.reserve(expected * 4);
    check(cudaMemcpyAsync(d.host_vertices.get(), d.ordered.get(), expected * 16,
                          cudaMemcpyDeviceToHost, stream),
          "copying simplices");
    timer.mark(stage::kDeviceToHost);
    check(cudaStreamSynchronize(stream), "computing dual edges");

    const Counters& got = *host_counters.get();
    const std::size_t found = got.cursor[2];
    const BlockStatistics& met = got.blocks;
    // The next run's room: of this alpha, or of this very run once more.
    TetrahedraNeed next = need;
    next.alpha = alpha;
    next.tetrahedra = found;
    if (met.balls > 0) {
      const double balls = static_cast<double>(met.balls),
                   list = static_cast<double>(met.entries) / balls;
      const double deviation =
          std::sqrt(std::max(0.0, static_cast<double>(met.entry_squares) / balls - list * list));
      if (met.deferred > n / 2000) next.margin *= 1.3;
      // Balls without room count no triangles; half of their neighbours' pairs are a fair start.
      const double seen = static_cast<double>(met.triangles) / balls;
      const bool unseen = met.deferred > p.deferred_limit;
      choose_room(next, fair_share(*this),
                  {list, deviation, unseen ? std::max(seen, list * list / 8) : seen,
                   unseen ? 6.5 : static_cast<double>(found) / static_cast<double>(n)});
    }
    if (met.longest_list > need.ball.list || met.most_triangles > need.ball.triangles ||
        met.most_kept > need.ball.kept || met.deferred > p.deferred_limit || found > out.capacity) {
      const std::uint32_t list = std::max(need.ball.list, whole_words(met.longest_list));
      next.ball = {list, list, list,
                   std::max(need.ball.triangles, met.most_triangles + met.most_triangles / 8),
                   std::max(need.ball.kept, met.most_kept + met.most_kept / 8)};
      next.tetrahedra = std::max(need.tetrahedra, found + found / 8);
      need = next;
      continue;
    }
    if (found > expected) {
      d.host_vertices.reserve(found * 4 + found / 2);
      check(cudaMemcpyAsync(d.host_vertices.get(), d.ordered.get(), found * 16,
                            cudaMemcpyDeviceToHost, stream),
            "copying simplices");
      check(cudaStreamSynchronize(stream), "copying simplices");
    }
    remember(*this, next);
    result.fits = true;
    result.exact_balls = got.exact_count;
    result.tetrahedra.simplices = {
        reinterpret_cast<const std::array<BallIndex, 4>*>(d.host_vertices.get()), found};
    timer.report();
    return result;
  }
  return result;
}

}  // namespace alphascope::gpu
