// A run of the facet engine on the device: dual edges, then the result in lexicographic order. A
// run that finds too little room is repeated with what it needed.
#include "gpu/dual_edge_kernels.cuh"
#include "gpu/gather_kernels.cuh"
#include "gpu/pipeline_state.cuh"
#include "gpu/room.cuh"

namespace alphascope::gpu {
namespace {

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
      if (need.counted) {
        copy(layout);
        timer_.mark(stage::kDeviceToHost);
      }
      check(cudaStreamSynchronize(s_.stream), "computing dual edges");
      const Need next = next_need(need);
      if (!was_enough(need, next)) {
        need = grown(need, next);
        continue;
      }
      remember(s_, next);
      const ResultLayout found(next.counts, whole_);
      if (!need.counted) {
        copy(layout, found);
        timer_.mark(stage::kDeviceToHost);
        check(cudaStreamSynchronize(s_.stream), "copying the result");
      }
      timer_.report();
      return result(need.counted ? layout : found, next.counts);
    }
    PipelineResult none;
    none.fits = false;
    return none;
  }

 private:
  bool blocks_fit(const Need& need) const {
    const std::size_t shared =
        std::max(block_memory_bytes(make_problem(s_, plan_, need.block, need.balls_per_block)),
                 block_memory_bytes(make_problem(s_, plan_, need.ball, 1)));
    return shared + sizeof(BlockBalls) <= static_cast<std::size_t>(s_.shared_limit) &&
           need.ball.search < kMaxList && need.ball.triangles < kMaxTriangles &&
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
    const DualEdgeProblem p = make_problem(s_, plan_, need.block, need.balls_per_block);
    const auto grid =
        static_cast<unsigned>((s_.n + need.balls_per_block - 1) / need.balls_per_block);
    // Two and three words at compile time are slower than any number at run time: unrolled, lanes
    // in different words do not run together.
    if (is_culled(need.mean_found)) {
      start(dual_edges_filtered<kWhole, true, 0>, grid, p, sorted, out);
    } else if (p.words == 1) {
      start(dual_edges_filtered<kWhole, false, 1>, grid, p, sorted, out);
    } else {
      start(dual_edges_filtered<kWhole, false, 0>, grid, p, sorted, out);
    }
    timer_.mark(stage::kCandidatesAndFiltered);
    start(dual_edges_exact<kWhole>, static_cast<unsigned>(2 * s_.multiprocessors),
          make_problem(s_, plan_, need.ball, 1), sorted, out);
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
             s_.offset.get(), ordered.dimension[3], &s_.counters()->hash[3]);
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
    launch(place_faces, values, out, s_.balls.get(), s_.places.get(), ordered,
           &s_.counters()->hash[0]);
    launch(finish_edges, values, s_.balls.get(), out.edges, vertices);
    launch(pair_edges_and_vertices, per_edge, balls, out.edges, vertices, s_.pairs.get());
    s_.scan(s_.pairs.get(), s_.places.get(), s_.n + 1);
    // Not more blocks than needed at once: each adds to the one hash.
    const LaunchShape some{std::min(per_edge.blocks, 8u * s_.multiprocessors), kThreads, s_.stream};
    launch(place_edges_and_vertices, some, balls, s_.balls.get(), out.edges, vertices,
           s_.places.get(), ordered, &s_.counters()->edges_and_vertices, &s_.counters()->hash[0]);
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
    // A little more: which balls kernel III culls, though kernel II would not, varies from run to
    // run.
    next.candidates = got.edges + got.edges / 64;
    if (met.balls == 0) return next;
    const auto spread = [&](std::uint64_t sum, std::uint64_t squares) {
      const double balls = static_cast<double>(met.balls), mean = static_cast<double>(sum) / balls;
      const double variance = static_cast<double>(squares) / balls - mean * mean;
      return Means::Spread{mean, std::sqrt(std::max(0.0, variance))};
    };
    const Means::Spread found = spread(met.found, met.found_squares);
    Means::Spread list = spread(met.entries, met.entry_squares);
    next.mean_found = found.mean;
    // Lists that will not be culled are as long as what is found.
    if (!is_culled(found.mean)) list = found;
    // Balls without room count no triangles; half of their neighbours' pairs are a fair start.
    const double seen = static_cast<double>(met.triangles) / static_cast<double>(met.balls);
    const bool unseen = met.deferred > deferred_limit(need);
    const auto kept = static_cast<double>(whole_ ? got.triangles : got.tetrahedra);
    const Means means{found, list, unseen ? std::max(seen, list.mean * list.mean / 8) : seen,
                      unseen ? (whole_ ? 15 : 6.5) : kept / static_cast<double>(s_.n)};
    choose_room(s_, next, means);
    if (met.deferred > std::max<std::size_t>(32, s_.n / 2000)) widen(next, means, unseen);
    return next;
  }

  // More room for the next run's balls, if that does not cost balls a block (what is left to kernel
  // III is cheaper) or must be.
  void widen(Need& need, const Means& means, bool must) const {
    Need wide = need;
    wide.margin *= 1.2;
    choose_room(s_, wide, means);
    if (must || wide.balls_per_block == need.balls_per_block) need = wide;
  }

  std::uint32_t deferred_limit(const Need& need) const {
    return make_problem(s_, plan_, need.block, need.balls_per_block).deferred_limit;
  }

  bool was_enough(const Need& need, const Need& next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    return met.most_found <= need.ball.search && met.longest_list <= need.ball.list &&
           met.most_triangles <= need.ball.triangles && met.most_kept <= need.ball.kept &&
           met.deferred <= deferred_limit(need) && need.counts.cover(next.counts) &&
           (!whole_ || s_.host_counters.get()->edges <= need.candidates);
  }

  // What the next attempt gets. Edges and vertices were not counted if the rest did not fit.
  Need grown(const Need& need, Need next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    const auto more = [](auto value) { return value + value / 8; };
    const std::uint32_t list = std::max(need.ball.list, whole_words(met.longest_list));
    next.ball = {std::max(need.ball.search, whole_words(met.most_found)),
                 list,
                 list,
                 list,
                 std::max(need.ball.triangles, more(met.most_triangles)),
                 std::max(need.ball.kept, more(met.most_kept))};
    next.counted = false;
    for (int d = 0; d < 4; ++d) next.counts[d] = std::max(need.counts[d], more(next.counts[d]));
    next.candidates = std::max(need.candidates, next.candidates);
    return next;
  }

  // All of the result's memory.
  void copy(const ResultLayout& layout) {
    s_.host_result.reserve(layout.bytes);
    check(cudaMemcpyAsync(s_.host_result.get(), s_.result.get(), layout.bytes,
                          cudaMemcpyDeviceToHost, s_.stream),
          "copying the result");
  }
  // Only what was found, to where it fits exactly.
  void copy(const ResultLayout& from, const ResultLayout& to) {
    s_.host_result.reserve(to.bytes);
    const auto bring = [&](std::size_t begin, std::size_t place, std::size_t bytes) {
      if (bytes == 0) return;
      check(cudaMemcpyAsync(s_.host_result.get() + place, s_.result.get() + begin, bytes,
                            cudaMemcpyDeviceToHost, s_.stream),
            "copying the result");
    };
    for (int d = whole_ ? 0 : 3; d < 4; ++d) {
      const ResultLayout::Section &source = from.dimension[d], &target = to.dimension[d];
      const std::size_t count = to.room[d];
      bring(source.vertices, target.vertices, count * 4 * static_cast<std::size_t>(d + 1));
      if (!whole_) continue;
      bring(source.value, target.value, count * 4);
      if (d < 3) bring(source.simplex_class, target.simplex_class, count);
    }
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
    for (int d = 0; d < 4; ++d) {
      result.hash.sum[d] = s_.host_counters.get()->hash[d];
      result.hash.count[d] = whole_ || d == 3 ? counts[d] : 0;
    }
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
