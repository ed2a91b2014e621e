// The whole alpha complex on the device: facet polygons, then vertices from the edges.
#include "gpu/facet_kernels.cuh"
#include "gpu/pipeline_state.cuh"

namespace alphascope::gpu {

PipelineResult FacetPipeline::State::run_whole(double alpha, const CancelToken& cancel,
                                               StageTimes* times) {
  State& s = *this;
  PipelineResult result;
  const std::optional<Problem> plan = s.plan(alpha);
  if (!plan) {
    result.fits = false;
    return result;
  }
  Problem p = *plan;
  for (int d = 1; d < 4; ++d) {
    s.dimension[d].start.reserve(s.n);
    s.dimension[d].count.reserve(s.n);
    s.dimension[d].offset.reserve(s.n);
    s.dimension[d].reserve(std::max<std::size_t>(s.n * (d == 3 ? 3 : 6), 1024), d + 1, true);
  }
  s.vertex_state.reserve(s.n);
  s.flags.reserve(s.n);
  s.nearest.reserve(s.n);
  s.present.reserve(s.n);
  s.dimension[0].offset.reserve(s.n + 1);
  s.dimension[0].reserve(s.n, 1, true);

  EventTimer timer(s.stream, times);
  State::Need need = s.expected_need(alpha);
  for (int attempt = 0;; ++attempt) {
    cancel.throw_if_cancelled();
    // As many balls a block as its memory comfortably holds, but blocks for all multiprocessors.
    p.list_capacity = (need.list + 7) / 8 * 8;
    const int fair = static_cast<int>(s.n / (static_cast<std::size_t>(s.multiprocessors) * 4));
    p.balls_per_block = std::clamp(std::min(1024 / p.list_capacity, fair), 1, kMaxBallsPerBlock);
    p.staging_capacity = need.staging * p.balls_per_block;
    Problem exact = p;
    exact.balls_per_block = 1;
    const std::size_t shared = block_memory_bytes(p);
    const std::size_t shared_exact = block_memory_bytes(exact);
    if (shared > static_cast<std::size_t>(s.shared_limit) || p.list_capacity > kMaxList) {
      result.fits = false;
      return result;
    }

    timer.restart();
    const SortedBalls sorted = s.sort_into_cells(p, timer);
    Counters* c = s.counters();
    const Output out{s.device_simplices<2>(true),
                     s.device_simplices<3>(true),
                     s.device_simplices<4>(true),
                     s.vertex_state.get(),
                     s.exact_list.get(),
                     &c->exact_count,
                     &c->needed_list,
                     &c->needed_staging,
                     &c->failures};
    for (int d = 1; d < 4; ++d) s.zero(s.dimension[d].count.get(), s.n * 4);
    s.zero(s.vertex_state.get(), s.n);
    const unsigned blocks =
        static_cast<unsigned>((s.n + p.balls_per_block - 1) / p.balls_per_block);
    const auto launch = [&](auto kernel, unsigned grid, const Problem& problem, std::size_t bytes) {
      check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                 static_cast<int>(bytes)),
            "preparing a kernel");
      kernel<<<grid, kBlockThreads, bytes, s.stream>>>(problem, sorted, out);
      check(cudaGetLastError(), "starting a kernel");
    };
    launch(facets_filtered, blocks, p, shared);
    timer.mark(stage::kCandidatesAndFiltered);
    const unsigned exact_blocks = static_cast<unsigned>(2 * s.multiprocessors);
    launch(facets_exact, exact_blocks, exact, shared_exact);
    timer.mark(stage::kExactValidity);

    s.order<2>(true);
    s.order<3>(true);
    s.order<4>(true);
    s.zero(s.flags.get(), s.n * 4);
    check(cudaMemsetAsync(s.nearest.get(), 0xff, s.n * 4, s.stream), "clearing device memory");
    gather_vertices<<<4 * s.multiprocessors, kThreads, 0, s.stream>>>(
        s.dimension[1].ordered.get(), s.dimension[1].ordered_value.get(),
        s.dimension[1].ordered_class.get(), &c->cursor[0],
        static_cast<std::uint32_t>(s.dimension[1].simplices(2, true)), s.vertex_state.get(),
        s.flags.get(), s.nearest.get());
    mark_vertices<<<blocks_for(s.n), kThreads, 0, s.stream>>>(p.ball_count, s.vertex_state.get(),
                                                              s.flags.get(), s.present.get());
    s.scan(s.present.get(), s.dimension[0].offset.get(), s.n);
    place_vertices<<<blocks_for(s.n), kThreads, 0, s.stream>>>(
        p.ball_count, s.balls.get(), s.vertex_state.get(), s.flags.get(), s.nearest.get(),
        s.present.get(), s.dimension[0].offset.get(), s.dimension[0].ordered.get(),
        s.dimension[0].ordered_value.get(), s.dimension[0].ordered_class.get());
    check(cudaMemcpyAsync(s.host_counters.get(), c, sizeof(Counters), cudaMemcpyDeviceToHost,
                          s.stream),
          "copying the counts");
    std::uint32_t vertex_tail[2] = {0, 0};
    check(cudaMemcpyAsync(&vertex_tail[0], s.present.get() + s.n - 1, 4, cudaMemcpyDeviceToHost,
                          s.stream),
          "copying the counts");
    check(cudaMemcpyAsync(&vertex_tail[1], s.dimension[0].offset.get() + s.n - 1, 4,
                          cudaMemcpyDeviceToHost, s.stream),
          "copying the counts");
    timer.mark(stage::kPrefixSum);
    check(cudaStreamSynchronize(s.stream), "computing facets");

    // Was everything counted on? If not, once more with what it needs.
    const Counters& got = *s.host_counters.get();
    bool again = false;
    if (got.needed_list > static_cast<std::uint32_t>(p.list_capacity)) {
      need.list = static_cast<int>(got.needed_list);
      again = true;
    }
    if (got.needed_staging > static_cast<std::uint32_t>(p.staging_capacity)) {
      need.staging = static_cast<int>(got.needed_staging) / p.balls_per_block * 5 / 4 + 4;
      again = true;
    }
    for (int d = 1; d < 4; ++d) {
      const std::size_t count = got.cursor[d - 1];
      if (count > s.dimension[d].simplices(d + 1, true)) {
        s.dimension[d].reserve(count + count / 8, d + 1, true);
        again = true;
      }
    }
    if (again) {
      if (attempt < 8) continue;
      result.fits = false;
      return result;
    }
    if (got.failures > 0) {
      result.fits = false;
      return result;
    }

    s.note_need({alpha, std::max(8, static_cast<int>(got.needed_list)), need.staging});
    cancel.throw_if_cancelled();
    result.exact_balls = got.exact_count;
    result.vertices = s.fetch<1>(vertex_tail[0] + vertex_tail[1], true);
    result.edges = s.fetch<2>(got.cursor[0], true);
    result.triangles = s.fetch<3>(got.cursor[1], true);
    result.tetrahedra = s.fetch<4>(got.cursor[2], true);
    timer.mark(stage::kDeviceToHost);
    check(cudaStreamSynchronize(s.stream), "copying the result");
    timer.report();
    return result;
  }
}

}  // namespace alphascope::gpu
