// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the dual-edge engine on the device: dual edges, then the result in lexicographic order. A
// run with too little room is repeated with the room that it needed.
#include <string>

#include "core/run/internal_error.hpp"
#include "gpu/dual_edge/dual_edge_kernels.cuh"
#include "gpu/dual_edge/ordering.cuh"
#include "gpu/dual_edge/result_copy.cuh"
#include "gpu/dual_edge/room.cuh"

namespace alphascope::gpu {
namespace {

// A kernel that does nothing. While it runs in one queue, a kernel of another queue that waits for
// the same event can already begin.
__global__ void empty_kernel() {}

// The computation of one request.
class Run {
 public:
  Run(State& state, const Problem& plan, StageTimes* times)
      : s_(state),
        q_(state.queues),
        plan_(plan),
        whole_(plan.whole),
        result_(state, plan.whole),
        timer_(state.queues.main, times) {}
  // However a run ends, it waits for the device, so that the next run finds the device idle and the
  // buffers free.
  ~Run() {
    if (busy_) q_.wait(true);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  PipelineResult compute(const CancelToken& cancel) {
    Need need = first_need(s_, plan_.alpha, whole_);
    if (need.alpha < plan_.alpha) {
      add_headroom(need);
      Need roomy = need;
      roomy.ball = with_headroom(need.ball, need.longest);
      if (blocks_fit(roomy)) need = roomy;
    }
    for (int attempt = 1; attempt <= s_.most_attempts; ++attempt) {
      cancel.throw_if_cancelled();
      if (!blocks_fit(need)) break;
      const ResultLayout layout(need.counts, whole_);
      chunks_ = static_cast<int>(
          std::min<std::size_t>(chunk_count(s_, need, layout.bytes), most_chunks()));
      reserve(need, layout);
      timer_.restart();
      busy_ = true;
      enqueue(need, layout);
      const bool sent = is_known(need) || send_counted(layout, cancel);
      if (sent) {
        timer_.mark(stage::kDeviceToHost, chunks_ > 1 ? q_.copying : q_.main);
        result_.write_interior_classes(layout);
      }
      check(q_.wait(chunks_ > 1), "computing dual edges");
      const Need next = next_need(need);
      if (!was_enough(need, next)) {
        need = grown(need, next);
        continue;
      }
      expect_all_edges();
      remember(s_, next);
      const ResultLayout found(next.counts, whole_);
      if (!sent) {
        make_room(found);
        result_.found(layout, found, q_.main);
        timer_.mark(stage::kDeviceToHost, q_.main);
        result_.write_interior_classes(found);
        check(cudaStreamSynchronize(q_.main), "copying the result");
      }
      busy_ = false;
      timer_.report();
      PipelineResult result = result_.result(sent ? layout : found, next.counts);
      result.attempts = attempt;
      if (whole_) s_.keep_on_device(layout, next.counts, plan_.alpha);
      s_.tetrahedra_on_device = {
          reinterpret_cast<const BallIndex*>(s_.result.get() + layout.dimension[3].vertices),
          nullptr, next.counts[3]};
      return result;
    }
    PipelineResult none;
    none.fits = false;
    return none;
  }

 private:
  // The problems of kernel II and of kernel III.
  DualEdgeProblem block_problem(const Need& need) const {
    return make_problem(s_, plan_, need.block, need.balls_per_block, need.cull);
  }
  DualEdgeProblem ball_problem(const Need& need) const {
    return make_problem(s_, plan_, need.ball, 1, true);
  }

  bool blocks_fit(const Need& need) const {
    const std::size_t shared =
        std::max(block_problem(need).layout.bytes, ball_problem(need).layout.bytes);
    return shared + sizeof(BlockBalls) <= static_cast<std::size_t>(s_.shared_limit) &&
           need.ball.search < kMaxList && need.ball.triangles < kMaxTriangles &&
           need.block.triangles < kMaxTriangles && need.block.rows < kMaxRows;
  }

  // Throws std::bad_alloc if counts are too large. Slabs then have fewer simplices in a run.
  static void require_countable(const Need& need) {
    const std::size_t counts[] = {need.counts[0], need.counts[1], need.counts[2], need.counts[3],
                                  need.candidates};
    if (!are_countable(counts)) throw std::bad_alloc();
  }

  void reserve(const Need& need, const ResultLayout& layout) {
    require_countable(need);
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
      s_.edges.end.reserve(edges);
      s_.edges.least.reserve(edges);
      s_.edges.flags.reserve(edges);
      s_.edges.start.reserve(s_.n);
      s_.places.reserve(s_.n + 1);
      s_.edges_found.reserve(s_.n);
      if (chunks_ > 1) s_.pending.reserve(triangles);
    }
    const std::size_t room = s_.result.capacity();
    s_.result.reserve(layout.bytes);
    // The copy may include bytes that no kernel writes, so new memory is cleared.
    if (s_.result.capacity() != room) s_.fill(s_.result.get(), 0, s_.result.capacity());
  }

  DualEdgeOutput output() {
    Counters* c = s_.counters();
    const auto capacity = [](const auto& buffer) {
      return static_cast<std::uint32_t>(buffer.capacity());
    };
    return {
        {s_.tetrahedra.vertices.get(), capacity(s_.tetrahedra.vertices), &c->tetrahedra,
         s_.tetrahedra.start.get(), s_.zeroed_array(plan_, 0)},
        {s_.triangles.vertices.get(), s_.triangles.info.get(), s_.triangles.attached_to.get(),
         capacity(s_.triangles.attached_to), &c->triangles, s_.triangles.start.get(),
         s_.zeroed_array(plan_, 1)},
        {s_.edges.end.get(), s_.edges.least.get(), s_.edges.flags.get(), capacity(s_.edges.flags),
         &c->edges, s_.edges.start.get(), s_.zeroed_array(plan_, 2), &c->missing_edges},
        s_.zeroed_array(plan_, 4),
        nullptr,
        nullptr,
        &c->blocks};
  }

  // The first ball of a chunk. It does not depend on the size of blocks, so counts of an earlier
  // run stay valid. The last chunk is short, because nothing runs beside its copy. For tetrahedra
  // alone the chunk before it is short too, so that its copy is done by then. A whole complex in
  // many chunks also has a short first chunk: its time is limited by the copies, so they should
  // begin early.
  std::uint32_t chunk_begin(int number) const {
    const std::size_t balls = most_chunks() * quarters_before(number) / quarters_before(chunks_);
    return static_cast<std::uint32_t>(std::min(s_.n, balls * kMaxBallsPerBlock));
  }
  // The length of all chunks before, in quarters of a full chunk. No chunk may be empty.
  std::size_t quarters_before(int number) const {
    const bool uneven = most_chunks() >= 4 * static_cast<std::size_t>(chunks_);
    const auto quarters = [&](int chunk) -> std::size_t {
      const int after = chunks_ - 1 - chunk;
      if (!uneven) return 4;
      if (whole_) return after == 0 || (chunk == 0 && chunks_ > 4) ? 2 : 4;
      return after == 0 ? 1 : after == 1 ? 2 : 4;
    };
    std::size_t sum = 0;
    for (int chunk = 0; chunk < number; ++chunk) sum += quarters(chunk);
    return sum;
  }
  std::size_t most_chunks() const { return (s_.n + kMaxBallsPerBlock - 1) / kMaxBallsPerBlock; }

  Part part(int number, DualEdgeOutput out) {
    Counters* counters = s_.counters();
    const std::uint32_t begin = chunk_begin(number);
    out.exact_list = s_.exact_list.get() + begin;
    out.exact_count = &counters->exact_count[number];
    return {{begin, chunk_begin(number + 1), &counters->totals[number]}, out};
  }

  struct Blocks {
    unsigned number;
    cudaStream_t stream;
  };
  template <class Kernel>
  void start(Kernel kernel, const Blocks& blocks, const DualEdgeProblem& problem,
             const SortedBalls& sorted, const DualEdgeOutput& out) {
    const std::size_t bytes = problem.layout.bytes;
    if (bytes > 40 * 1024) {
      check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                 static_cast<int>(bytes)),
            "preparing a kernel");
    }
    launch(kernel, {blocks.number, kBlockThreads, blocks.stream, bytes}, problem, sorted, out);
    check(cudaGetLastError(), "starting a kernel");
  }

  template <bool kWhole>
  void filter(const Need& need, const SortedBalls& sorted, const Part& part, cudaStream_t stream) {
    DualEdgeProblem p = block_problem(need);
    p.begin = part.chunk.begin;
    p.end = part.chunk.end;
    const Blocks blocks{(p.end - p.begin + need.balls_per_block - 1) / need.balls_per_block,
                        stream};
    // Only one word is a compile-time constant. Kernels for two or three words would be slower than
    // that for any number: in their unrolled loops, lanes that are at different words do not run
    // together.
    if (p.cull) {
      start(dual_edges_filtered<kWhole, true, 0>, blocks, p, sorted, part.out);
    } else if (p.words == 1) {
      start(dual_edges_filtered<kWhole, false, 1>, blocks, p, sorted, part.out);
    } else {
      start(dual_edges_filtered<kWhole, false, 0>, blocks, p, sorted, part.out);
    }
  }

  // Queues everything but the copies of simplices whose number is not yet known.
  void enqueue(const Need& need, const ResultLayout& layout) {
    const SortedBalls sorted = s_.sort_into_cells(plan_, timer_);
    const DualEdgeOutput out = output();
    if (chunks_ > 1) {
      q_.sorted.record(q_.main);
      q_.sorted.make_wait(q_.other);
      launch(empty_kernel, {1, 32, q_.other});
    }
    for (int c = 0; c < chunks_; ++c) {
      const cudaStream_t stream = q_.filtering(c);
      const Part of = part(c, out);
      whole_ ? filter<true>(need, sorted, of, stream) : filter<false>(need, sorted, of, stream);
      if (chunks_ > 1) q_.filtered[c].record(stream);
      if (c == chunks_ - 1) timer_.mark(stage::kCandidatesAndFiltered, stream);
    }
    const bool known = is_known(need);
    if (known) make_room(layout);
    for (int c = 0; c < chunks_; ++c) {
      order(need, sorted, part(c, out), layout, c);
      if (known && chunks_ > 1) send(layout, need.totals.data(), c);
      if (!known || c == chunks_ - 1) fetch_counts(c);
    }
    if (known && chunks_ == 1) send_all(layout);
  }

  // Queues kernel III of a chunk, and the ordering of its simplices.
  void order(const Need& need, const SortedBalls& sorted, const Part& part,
             const ResultLayout& layout, int number) {
    const bool several = chunks_ > 1, last = number == chunks_ - 1;
    const cudaStream_t deciding = several ? q_.deciding : q_.main,
                       stream = several ? q_.ordering : q_.main;
    if (several) q_.filtered[number].make_wait(deciding);
    const auto blocks = static_cast<unsigned>(2 * s_.multiprocessors);
    const auto exact = whole_ ? dual_edges_exact<true> : dual_edges_exact<false>;
    start(exact, {blocks, deciding}, ball_problem(need), sorted, part.out);
    if (last) timer_.mark(stage::kExactValidity, deciding);
    if (several) {
      q_.decided[number].record(deciding);
      q_.decided[number].make_wait(stream);
    }
    Ordering ordering(s_, plan_, layout, stream);
    ordering.order_faces(part);
    if (several || whole_) q_.faces_ordered[number].record(stream);
    if (whole_) ordering.order_edges_and_vertices(part);
    if (several) q_.ordered[number].record(stream);
    if (last) timer_.mark(stage::kPrefixSum, stream);
  }

  // Copies the numbers of simplices after a chunk; after the last one, all counters. Copies wait
  // for others in their direction, so those of several chunks have a queue of their own. Ordering
  // the next chunk must not wait for the copy of the previous one.
  void fetch_counts(int number) {
    const bool several = chunks_ > 1;
    const cudaStream_t stream = several ? q_.counting : q_.main;
    if (several) q_.ordered[number].make_wait(stream);
    const Counters* from = s_.counters();
    Counters* to = s_.host_counters.get();
    check(number == chunks_ - 1
              ? cudaMemcpyAsync(to, from, sizeof(Counters), cudaMemcpyDeviceToHost, stream)
              : cudaMemcpyAsync(&to->totals[number + 1], &from->totals[number + 1], sizeof(Totals),
                                cudaMemcpyDeviceToHost, stream),
          "copying the counts");
    if (several) q_.counted[number].record(stream);
  }

  // Reserves host memory for the result. The device may be working meanwhile.
  void make_room(const ResultLayout& layout) {
    if (result_.make_room(layout))
      timer_.mark(stage::kMakingRoom, chunks_ > 1 ? q_.copying : q_.main);
  }

  // Returns whether the number of simplices of each chunk is known.
  bool is_known(const Need& need) const {
    return need.counted && need.totals.size() == static_cast<std::size_t>(chunks_);
  }

  // Queues the copies of the simplices that a chunk adds, to begin as soon as these are ready.
  // `after`: numbers of simplices after each chunk. Returns false if there is no room; the run is
  // then repeated.
  bool send(const ResultLayout& layout, const Totals* after, int number) {
    const Totals none{}, &before = number == 0 ? none : after[number - 1];
    if (!ResultCopy::has_place(layout, before, after[number])) return false;
    q_.faces_ordered[number].make_wait(q_.copying);
    result_.added_faces(layout, before, after[number], q_.copying);
    if (!whole_) return true;
    q_.ordered[number].make_wait(q_.copying);
    result_.added_edges_and_vertices(layout, before, after[number], q_.copying);
    return true;
  }
  // Sends the result of a single chunk. Its faces are sent while its edges are ordered.
  void send_all(const ResultLayout& layout) {
    const cudaStream_t stream = whole_ ? cudaStream_t{q_.copying} : q_.main;
    if (whole_) q_.faces_ordered[0].make_wait(stream);
    result_.all_faces(layout, stream);
    if (!whole_) return;
    q_.faces_sent.record(stream);
    result_.all_edges_and_vertices(layout, q_.main);
    q_.faces_sent.make_wait(q_.main);
  }
  // Sends the simplices of all chunks, each when it is counted. Returns false for a single chunk:
  // nothing is sent then.
  bool send_counted(const ResultLayout& layout, const CancelToken& cancel) {
    if (chunks_ == 1) return false;
    make_room(layout);
    bool room = true;
    for (int c = 0; c < chunks_ && room; ++c) {
      check(cudaEventSynchronize(q_.counted[c]), "computing dual edges");
      cancel.throw_if_cancelled();
      room = send(layout, s_.host_counters.get()->totals + 1, c);
    }
    return true;
  }

  // The room for the next run: with this alpha, or for the same run once more.
  Need next_need(const Need& need) const {
    const Counters& got = *s_.host_counters.get();
    const BlockStatistics& met = got.blocks;
    Need next = need;
    next.alpha = plan_.alpha;
    next.counted = true;
    next.totals.assign(got.totals + 1, got.totals + 1 + chunks_);
    next.longest = {met.most_found, met.longest_list, 0, 0, met.most_triangles, 0, 0,
                    met.most_kept};
    // Edges and vertices were not counted if the rest did not fit.
    const Totals& all = next.totals.back();
    next.counts = {{all.of[0], all.of[1], got.triangles, got.tetrahedra}};
    // A little more than was found, because kernel III may leave out neighbours that kernel II
    // keeps, and the balls that go to kernel III vary from run to run.
    next.candidates = std::size_t{got.edges} + got.edges / 64;
    if (met.found.number == 0) return next;
    const Demand::Spread found = spread_of(met.found);
    const bool cull = is_culled(found.mean, need.cull), few = met.deferred <= deferred_limit(s_);
    if (cull != need.cull) {
      choose_room(s_, next, guessed(found, cull, whole_));
      return next;
    }
    Demand demand = measured(met, need.balls_per_block, cull);
    if (!few) {  // not everything was seen, for lack of room
      next.margin = 1.3 * need.margin;
      demand = larger(guessed(found, cull, whole_), demand);
    } else {
      next.margin = next_margin(need.margin, met.deferred, met.too_long, deferred_limit(s_));
    }
    choose_room(s_, next, demand);
    return next;
  }

  bool was_enough(const Need& need, const Need& next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    return met.most_found <= need.ball.search && met.longest_list <= need.ball.list &&
           met.most_triangles <= need.ball.triangles && met.most_kept <= need.ball.kept &&
           met.deferred <= deferred_limit(s_) && need.counts.cover(next.counts) &&
           copied_right(need, next) &&
           (!whole_ || s_.host_counters.get()->edges <= need.candidates);
  }

  // Checks that a run with room for everything found all edges.
  void expect_all_edges() const {
    const std::uint32_t missing = s_.host_counters.get()->missing_edges;
    if (missing == 0) return;
    throw InternalError("The GPU found " + std::to_string(missing) +
                        " triangles of the complex without one of their edges.");
  }

  // Returns whether each chunk found as many simplices as were copied.
  bool copied_right(const Need& need, const Need& next) const {
    if (chunks_ == 1 || !is_known(need)) return true;
    return std::equal(need.totals.begin(), need.totals.end(), next.totals.begin(),
                      [](const Totals& a, const Totals& b) {
                        return std::equal(std::begin(a.of), std::end(a.of), std::begin(b.of));
                      });
  }

  // The room for the next attempt.
  Need grown(const Need& need, Need next) const {
    const BlockStatistics& met = s_.host_counters.get()->blocks;
    const auto more = [](auto value) { return value + value / 8; };
    next.ball = enough_for(need.ball, met.most_found, met.longest_list, more(met.most_triangles),
                           more(met.most_kept));
    next.counted = false;
    for (int d = 0; d < 4; ++d) next.counts[d] = std::max(need.counts[d], more(next.counts[d]));
    next.candidates = std::max(need.candidates, next.candidates);
    return next;
  }

  State& s_;
  Queues& q_;
  const Problem plan_;
  const bool whole_;
  int chunks_ = 1;
  bool busy_ = false;
  ResultCopy result_;
  EventTimer timer_;
};

}  // namespace

PipelineResult DualEdgePipeline::run(const LatticeAlpha& alpha, bool tetrahedra_only,
                                     const CancelToken& cancel, StageTimes* times) {
  State& s = *state_;
  s.on_device.reset();
  s.tetrahedra_on_device = {};
  if (s.n == 0 || alpha.plus(std::int64_t{s.max_radius} * s.max_radius) < 0) return {};
  const std::optional<Problem> plan = s.plan(alpha, !tetrahedra_only);
  if (!plan) {
    PipelineResult none;
    none.fits = false;
    return none;
  }
  return Run(s, *plan, times).compute(cancel);
}

}  // namespace alphascope::gpu
