// A run of the facet engine on the device: dual edges, then the result in lexicographic order. Room
// is estimated from what earlier runs met; a run that finds too little is repeated with what it
// needed.
#include "gpu/dual_edge_kernels.cuh"
#include "gpu/gather_kernels.cuh"
#include "gpu/pipeline_state.cuh"

namespace alphascope::gpu {
namespace {

using State = FacetPipeline::State;
using Need = State::Need;

// Of shared memory a block, so that several share a multiprocessor's: with what is static and
// reserved, six of long lists on Hopper. Fastest of what was tried on an H200.
constexpr std::size_t kBlockBytes = 30 * 1024, kLargeBlockBytes = 33 * 1024;
// Mean number of neighbours from which on covered discs are looked for. A whole complex looks at
// every disc anyway.
double long_list(bool whole) {
  return whole ? 20 : 26;
}

std::uint32_t whole_words(double list) {
  return static_cast<std::uint32_t>(std::ceil(std::max(1.0, list) / 32)) * 32;
}

// Of room_for().
constexpr double kLeastMore = 1, kMostMore = 3;

// What sampled blocks say about a ball's neighbours and triangles; `kept` as in BlockRoom.
struct Means {
  double list, deviation, triangles, kept;
};

// Room for blocks of so many balls: for lists `margin` times three standard deviations above the
// mean, for their sums `more` times that. Neighbours have similar surroundings, so a block's sum
// varies more than sums of independent balls would; triangles vary like squares of lists. Balls
// that find no room go to kernel III.
BlockRoom room_for(int balls, const Means& means, double margin, double more) {
  const double spread = 3 * margin * means.deviation;
  const double varied = more * spread / std::max(1.0, means.list) / std::sqrt(balls);
  const double lists = balls * means.list * (1.1 + varied),
               triangles = balls * means.triangles * (1.1 + 2 * varied);
  const double list = std::min(means.list + spread, static_cast<double>(kMaxList - 1));
  return {whole_words(list), static_cast<std::uint32_t>(lists) + 32,
          static_cast<std::uint32_t>(lists / 2) + 32,
          std::min<std::uint32_t>(static_cast<std::uint32_t>(triangles) + 64, kMaxTriangles - 1),
          static_cast<std::uint32_t>(balls * means.kept * (1.1 + 2 * varied)) + 16};
}

std::size_t bytes_of(const BlockRoom& room, int balls) {
  DualEdgeProblem p{};
  p.common.balls_per_block = balls;
  p.capacity = room;
  p.words = static_cast<int>(room.list / 32);
  return block_memory_bytes(p);
}

// The largest run of balls whose block stays within its share of shared memory, of which it then
// takes all that helps.
void choose_room(Need& need, std::size_t fair, const Means& means) {
  const std::size_t limit = means.list >= 20 ? kLargeBlockBytes : kBlockBytes;
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

// Balls a block when there are not enough to fill the machine.
std::size_t fair_share(const State& s) {
  return s.n / (static_cast<std::size_t>(s.multiprocessors) * 7);
}

// The need of this alpha, or of the nearest one above: less alpha never needs more.
Need first_need(const State& s, double alpha, bool whole) {
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
  Need need{alpha,   whole, 1, {},   {64, 64, 64, 1024, 64}, {{s.n, 5 * s.n, 6 * s.n, s.n}},
            8 * s.n, 12,    1, false};
  choose_room(need, fair_share(s), {need.mean_list, 3, 14, whole ? 5.0 : 1.5});
  return need;
}

void remember(State& s, const Need& need) {
  auto& all = s.needs;
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [&](const Need& n) { return n.alpha == need.alpha && n.whole == need.whole; }),
      all.end());
  if (all.size() >= 64) all.erase(all.begin());
  all.push_back(need);
}

DualEdgeProblem make_problem(const State& s, const Problem& plan, const BlockRoom& room,
                             int balls_per_block, double mean_list) {
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
  p.cull_facets = mean_list >= long_list(plan.whole);
  p.first_cuts = p.cull_facets ? 8 : 0;
  p.balls = s.balls.get();
  p.deferred_limit = static_cast<std::uint32_t>(std::max<std::size_t>(256, s.n / 200));
  return p;
}

// One request.
class Run {
 public:
  Run(State& state, const Problem& plan, StageTimes* times)
      : s_(state), plan_(plan), whole_(plan.whole), timer_(state.stream, times) {}

  PipelineResult compute(const CancelToken& cancel) {
    Need need = first_need(s_, plan_.alpha, whole_);
    for (int attempt = 0; attempt < 12; ++attempt) {
      cancel.throw_if_cancelled();
      if (!blocks_fit(need)) break;
      const ResultLayout layout(need.counts, whole_);
      reserve(need, layout);
      timer_.restart();
      enqueue(need, layout);
      // Of a known alpha, the result comes along at once.
      if (need.counted) copy(layout);
      timer_.mark(stage::kDeviceToHost);
      check(cudaStreamSynchronize(s_.stream), "computing dual edges");
      const Need next = next_need(need);
      if (!was_enough(need, next)) {
        need = grown(need, next);
        continue;
      }
      remember(s_, next);
      if (!need.counted) copy(layout, next.counts);
      timer_.report();
      return result(layout, next.counts);
    }
    PipelineResult none;
    none.fits = false;
    return none;
  }

 private:
  bool blocks_fit(const Need& need) const {
    const std::size_t shared =
        std::max(block_memory_bytes(
                     make_problem(s_, plan_, need.block, need.balls_per_block, need.mean_list)),
                 block_memory_bytes(make_problem(s_, plan_, need.ball, 1, need.mean_list)));
    return shared + sizeof(BlockBalls) <= static_cast<std::size_t>(s_.shared_limit) &&
           need.ball.list < kMaxList && need.ball.triangles < kMaxTriangles &&
           need.block.triangles < kMaxTriangles && need.block.rows < kMaxRows;
  }

  void reserve(const Need& need, const ResultLayout& layout) {
    s_.tetrahedra.vertices.reserve(std::max<std::size_t>(need.counts[3], 1024));
    s_.tetrahedra.start.reserve(s_.n);
    s_.offset.reserve(s_.n + 1);
    if (whole_) {
      const std::size_t triangles = std::max<std::size_t>(need.counts[2], 1024),
                        edges = std::max<std::size_t>(need.candidates, 1024);
      s_.triangles.vertices.reserve(3 * triangles);
      s_.triangles.info.reserve(triangles);
      s_.triangles.attached_to.reserve(triangles);
      s_.triangles.start.reserve(s_.n);
      s_.edges.begin.reserve(edges);
      s_.edges.end.reserve(edges);
      s_.edges.least.reserve(edges);
      s_.edges.flags.reserve(edges);
      s_.edges.start.reserve(s_.n);
      s_.pairs.reserve(s_.n + 1);
      s_.places.reserve(s_.n + 1);
    }
    const std::size_t room = s_.result.capacity();
    s_.result.reserve(layout.bytes);
    // What is copied may be more than is found.
    if (s_.result.capacity() != room) s_.fill(s_.result.get(), 0, s_.result.capacity());
  }

  DualEdgeOutput output() {
    Counters* c = s_.counters();
    const auto capacity = [](const auto& buffer) {
      return static_cast<std::uint32_t>(buffer.capacity());
    };
    return {{s_.tetrahedra.vertices.get(), capacity(s_.tetrahedra.vertices), &c->tetrahedra,
             s_.tetrahedra.start.get(), s_.zeroed_array(plan_, 0)},
            {s_.triangles.vertices.get(), s_.triangles.info.get(), s_.triangles.attached_to.get(),
             capacity(s_.triangles.attached_to), &c->triangles, s_.triangles.start.get(),
             s_.zeroed_array(plan_, 1)},
            {s_.edges.begin.get(), s_.edges.end.get(), s_.edges.least.get(), s_.edges.flags.get(),
             capacity(s_.edges.flags), &c->edges, s_.edges.start.get(), s_.zeroed_array(plan_, 2)},
            s_.zeroed_array(plan_, 4),
            s_.exact_list.get(),
            &c->exact_count,
            &c->blocks};
  }

  template <class Kernel>
  void start(Kernel kernel, unsigned grid, const DualEdgeProblem& problem,
             const SortedBalls& sorted, const DualEdgeOutput& out) {
    const std::size_t bytes = block_memory_bytes(problem);
    if (bytes > 40 * 1024) {
      check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                 static_cast<int>(bytes)),
            "preparing a kernel");
    }
    launch(kernel, {grid, kBlockThreads, s_.stream, bytes}, problem, sorted, out);
    check(cudaGetLastError(), "starting a kernel");
  }

  template <bool kWhole>
  void dual_edges(const Need& need, const SortedBalls& sorted, const DualEdgeOutput& out) {
    const DualEdgeProblem p =
        make_problem(s_, plan_, need.block, need.balls_per_block, need.mean_list);
    const auto grid =
        static_cast<unsigned>((s_.n + need.balls_per_block - 1) / need.balls_per_block);
    // Two and three words at compile time are slower than any number at run time: unrolled, lanes
    // in different words do not run together.
    if (p.words == 1) {
      start(dual_edges_filtered<kWhole, 1>, grid, p, sorted, out);
    } else {
      start(dual_edges_filtered<kWhole, 0>, grid, p, sorted, out);
    }
    timer_.mark(stage::kCandidatesAndFiltered);
    start(dual_edges_exact<kWhole>, static_cast<unsigned>(2 * s_.multiprocessors),
          make_problem(s_, plan_, need.ball, 1, need.mean_list), sorted, out);
    timer_.mark(stage::kExactValidity);
  }

  void enqueue(const Need& need, const ResultLayout& layout) {
    const SortedBalls sorted = s_.sort_into_cells(plan_, timer_);
    const DualEdgeOutput out = output();
    OrderedResult ordered{};
    for (int d = 0; d < 4; ++d) {
      const ResultLayout::Section& at = layout.dimension[d];
      unsigned char* memory = s_.result.get();
      ordered.dimension[d] = {reinterpret_cast<std::uint32_t*>(memory + at.vertices),
                              reinterpret_cast<float*>(memory + at.value),
                              memory + at.simplex_class,
                              static_cast<std::uint32_t>(layout.room[d])};
    }
    if (whole_) {
      dual_edges<true>(need, sorted, out);
      gather(out, ordered);
    } else {
      dual_edges<false>(need, sorted, out);
      s_.scan(out.tetrahedra.count, s_.offset.get(), s_.n);
      launch(place_tetrahedra, {4u * s_.multiprocessors, kThreads, s_.stream}, out.tetrahedra,
             s_.offset.get(), ordered.dimension[3]);
    }
    check(cudaGetLastError(), "ordering the simplices");
    check(cudaMemcpyAsync(s_.host_counters.get(), s_.counters(), sizeof(Counters),
                          cudaMemcpyDeviceToHost, s_.stream),
          "copying the counts");
    timer_.mark(stage::kPrefixSum);
  }

  void gather(const DualEdgeOutput& out, const OrderedResult& ordered) {
    const int balls = plan_.ball_count;
    const VertexStates vertices{out.vertex_state, s_.zeroed_array(plan_, 3),
                                s_.zeroed_array(plan_, 5)};
    const LaunchShape per_ball{blocks_for(s_.n + 1), kThreads, s_.stream},
        per_edge{blocks_for((s_.n + 1) * kEdgeLanes), kThreads, s_.stream},
        values{2u * kValueBlocks * s_.multiprocessors, kValueThreads, s_.stream};
    launch(pair_counts, per_ball, balls, out.tetrahedra.count, out.triangles.count, s_.pairs.get());
    s_.scan(s_.pairs.get(), s_.places.get(), s_.n + 1);
    launch(place_faces, values, out, s_.balls.get(), s_.places.get(), ordered);
    launch(finish_edges, values, s_.balls.get(), out.edges, vertices);
    launch(pair_edges_and_vertices, per_edge, balls, out.edges, vertices, s_.pairs.get());
    s_.scan(s_.pairs.get(), s_.places.get(), s_.n + 1);
    launch(place_edges_and_vertices, per_edge, balls, s_.balls.get(), out.edges, vertices,
           s_.places.get(), ordered, &s_.counters()->edges_and_vertices);
  }

  // The next run's room: of this alpha, or of this very run once more.
  Need next_need(const Need& need) const {
    const Counters& got = *s_.host_counters.get();
    const BlockStatistics& met = got.blocks;
    Need next = need;
    next.alpha = plan_.alpha;
    next.counted = true;
    next.counts = {{high_of(got.edges_and_vertices), low_of(got.edges_and_vertices), got.triangles,
                    got.tetrahedra}};
    next.candidates = got.edges;
    if (met.balls == 0) return next;
    const double balls = static_cast<double>(met.balls),
                 list = static_cast<double>(met.entries) / balls;
    const double deviation =
        std::sqrt(std::max(0.0, static_cast<double>(met.entry_squares) / balls - list * list));
    next.mean_list = list;
    // Balls without room count no triangles; half of their neighbours' pairs are a fair start.
    const double seen = static_cast<double>(met.triangles) / balls;
    const bool unseen = met.deferred > deferred_limit(need);
    const auto kept = static_cast<double>(whole_ ? got.triangles : got.tetrahedra);
    const Means means{list, deviation, unseen ? std::max(seen, list * list / 8) : seen,
                      unseen ? (whole_ ? 15 : 6.5) : kept / static_cast<double>(s_.n)};
    choose_room(next, fair_share(s_), means);
    if (met.deferred > std::max<std::size_t>(32, s_.n / 2000)) widen(next, means, unseen);
    return next;
  }

  // More room for the next run's balls, if that does not cost balls a block (what is left to kernel
  // III is cheaper) or must be.
  void widen(Need& need, const Means& means, bool must) const {
    Need wide = need;
    wide.margin *= 1.2;
    choose_room(wide, fair_share(s_), means);
    if (must || wide.balls_per_block == need.balls_per_block) need = wide;
  }

  std::uint32_t deferred_limit(const Need& need) const {
    return make_problem(s_, plan_, need.block, need.balls_per_block, need.mean_list).deferred_limit;
  }

  bool was_enough(const Need& need, const Need& next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    return met.longest_list <= need.ball.list && met.most_triangles <= need.ball.triangles &&
           met.most_kept <= need.ball.kept && met.deferred <= deferred_limit(need) &&
           need.counts.cover(next.counts) && (!whole_ || next.candidates <= need.candidates);
  }

  // What the next attempt gets. Edges and vertices were not counted if the rest did not fit.
  Need grown(const Need& need, Need next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    const auto more = [](auto value) { return value + value / 8; };
    const std::uint32_t list = std::max(need.ball.list, whole_words(met.longest_list));
    next.ball = {list, list, list, std::max(need.ball.triangles, more(met.most_triangles)),
                 std::max(need.ball.kept, more(met.most_kept))};
    next.counted = false;
    for (int d = 0; d < 4; ++d) next.counts[d] = std::max(need.counts[d], more(next.counts[d]));
    next.candidates = std::max(need.candidates, more(next.candidates));
    return next;
  }

  // All of the result's memory.
  void copy(const ResultLayout& layout) {
    s_.host_result.reserve(layout.bytes);
    check(cudaMemcpyAsync(s_.host_result.get(), s_.result.get(), layout.bytes,
                          cudaMemcpyDeviceToHost, s_.stream),
          "copying the result");
  }
  // Only what was found.
  void copy(const ResultLayout& layout, const SimplexCounts& counts) {
    s_.host_result.reserve(layout.bytes);
    const auto bring = [&](std::size_t at, std::size_t bytes) {
      if (bytes == 0) return;
      check(cudaMemcpyAsync(s_.host_result.get() + at, s_.result.get() + at, bytes,
                            cudaMemcpyDeviceToHost, s_.stream),
            "copying the result");
    };
    for (int d = whole_ ? 0 : 3; d < 4; ++d) {
      const ResultLayout::Section& at = layout.dimension[d];
      bring(at.vertices, counts[d] * 4 * static_cast<std::size_t>(d + 1));
      if (!whole_) continue;
      bring(at.value, counts[d] * 4);
      if (d < 3) bring(at.simplex_class, counts[d]);
    }
    check(cudaStreamSynchronize(s_.stream), "copying the result");
  }

  template <int N>
  HostSimplices<N> simplices(const ResultLayout& layout, const SimplexCounts& counts) const {
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(std::uint32_t));
    const ResultLayout::Section& at = layout.dimension[N - 1];
    const unsigned char* memory = s_.host_result.get();
    HostSimplices<N> list;
    list.simplices = {reinterpret_cast<const std::array<BallIndex, N>*>(memory + at.vertices),
                      counts[N - 1]};
    if (!whole_) return list;
    list.values = {reinterpret_cast<const float*>(memory + at.value), counts[N - 1]};
    if (N < 4) {
      list.classes = {reinterpret_cast<const SimplexClass*>(memory + at.simplex_class),
                      counts[N - 1]};
    }
    return list;
  }

  PipelineResult result(const ResultLayout& layout, const SimplexCounts& counts) const {
    PipelineResult result;
    result.exact_balls = s_.host_counters.get()->exact_count;
    if (whole_) {
      result.vertices = simplices<1>(layout, counts);
      result.edges = simplices<2>(layout, counts);
      result.triangles = simplices<3>(layout, counts);
    }
    result.tetrahedra = simplices<4>(layout, counts);
    return result;
  }

  State& s_;
  const Problem plan_;
  const bool whole_;
  EventTimer timer_;
};

}  // namespace

PipelineResult FacetPipeline::run(double alpha, bool tetrahedra_only, const CancelToken& cancel,
                                  StageTimes* times) {
  State& s = *state_;
  if (s.n == 0 || static_cast<double>(s.max_radius) * s.max_radius + alpha < 0) return {};
  const std::optional<Problem> plan = s.plan(alpha, !tetrahedra_only);
  if (!plan) {
    PipelineResult none;
    none.fits = false;
    return none;
  }
  return Run(s, *plan, times).compute(cancel);
}

}  // namespace alphascope::gpu
