#include "gpu/facet_pipeline.hpp"

#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <cmath>

#include "core/geometry/coincident.hpp"
#include "gpu/device_buffer.cuh"
#include "gpu/facet_kernels.cuh"

namespace alphascope::gpu {
namespace {

constexpr int kThreads = 256;

unsigned blocks_for(std::size_t items) { return static_cast<unsigned>((items + kThreads - 1) / kThreads); }

// Differences stay exact in float and inside the double brackets.
constexpr double kMaxCutoff = 16777216.0;

// Start values of what is afterwards sized by counting: a list that is too short, or a staging area,
// is noticed by the kernel and the run repeated with what it needed.
constexpr int kFirstList = 32;
constexpr int kFirstStaging = 12;  // a ball of the block
// From here on there are balls enough to fill the machine with fewer lanes each.
constexpr std::size_t kManyBalls = 200000;
constexpr int kMaxList = 4095;  // 12 bits of a staging key

// Counters of one run, together so that one copy brings them back.
struct Counters {
  std::uint32_t cursor[3];
  std::uint32_t exact_count, needed_list, needed_staging, failures, padding;
};

// The device-side buffers of one dimension.
struct DimensionBuffers {
  DeviceBuffer<std::uint32_t> vertices, ordered;
  DeviceBuffer<float> value, ordered_value;
  DeviceBuffer<std::uint8_t> simplex_class, ordered_class;
  DeviceBuffer<std::uint32_t> start, count, offset;
  PinnedBuffer<std::uint32_t> host_vertices;
  PinnedBuffer<float> host_value;
  PinnedBuffer<std::uint8_t> host_class;

  // How many fit; the vertices alone may have grown for an earlier request without values.
  std::size_t simplices(int n, bool values) const {
    return values ? std::min(vertices.capacity() / n, value.capacity()) : vertices.capacity() / n;
  }
  void reserve(std::size_t simplices, int n, bool values) {
    vertices.reserve(simplices * n);
    ordered.reserve(simplices * n);
    if (!values) return;
    value.reserve(simplices);
    ordered_value.reserve(simplices);
    simplex_class.reserve(simplices);
    ordered_class.reserve(simplices);
  }
};

class EventTimer {
 public:
  EventTimer(cudaStream_t stream, StageTimes* times) : stream_(stream), times_(times) {
    if (times_ == nullptr) return;
    for (cudaEvent_t& e : events_) check(cudaEventCreate(&e), "creating an event");
    check(cudaEventRecord(events_[0], stream_), "recording an event");
  }
  ~EventTimer() {
    if (times_ == nullptr) return;
    for (const cudaEvent_t& e : events_) cudaEventDestroy(e);
  }
  void mark(std::string_view label) {
    if (times_ == nullptr) return;
    labels_.push_back(label);
    check(cudaEventRecord(events_[labels_.size()], stream_), "recording an event");
  }
  // After the stream has finished.
  void report() {
    if (times_ == nullptr) return;
    for (std::size_t s = 0; s < labels_.size(); ++s) {
      float milliseconds = 0;
      check(cudaEventElapsedTime(&milliseconds, events_[s], events_[s + 1]), "reading an event");
      times_->stages.push_back({std::string(labels_[s]), milliseconds, false});
    }
  }
  void restart() { labels_.clear(); if (times_ != nullptr) check(cudaEventRecord(events_[0], stream_), "recording an event"); }

 private:
  cudaStream_t stream_;
  StageTimes* times_;
  cudaEvent_t events_[16] = {};
  std::vector<std::string_view> labels_;
};

}  // namespace

struct FacetPipeline::State {
  cudaStream_t stream = nullptr;
  std::size_t n = 0;
  LatticePoint low, high;
  std::int32_t max_radius = 0;
  // What earlier runs needed, by alpha: the longest neighbour list and the fullest staging area.
  struct Need {
    double alpha;
    bool whole;
    int list, staging;
  };
  std::vector<Need> needs;
  int shared_limit = 0, multiprocessors = 1;

  PinnedBuffer<int4> host_balls;
  PinnedBuffer<Counters> host_counters;
  DeviceBuffer<int4> balls, sorted;
  DeviceBuffer<uint2> cell_and_rank;
  DeviceBuffer<std::uint32_t> index, cell_count, cell_start, exact_list;
  DeviceBuffer<float> reach;
  DeviceBuffer<Counters> counters;
  DeviceBuffer<std::uint8_t> vertex_state;
  DeviceBuffer<std::uint32_t> flags, nearest, present;
  DeviceBuffer<unsigned char> scratch;
  DimensionBuffers dimension[4];  // vertices, edges, triangles, tetrahedra

  ~State() {
    if (stream != nullptr) cudaStreamDestroy(stream);
  }

  // The need of the nearest alpha not below this one; less alpha never needs more.
  Need expected_need(double alpha, bool whole) const {
    Need best{alpha, whole, kFirstList, kFirstStaging};
    bool found = false;
    for (const Need& n : needs) {
      if (n.whole != whole || n.alpha < alpha || (found && n.alpha >= best.alpha)) continue;
      best = n;
      found = true;
    }
    if (!found) {
      for (const Need& n : needs) {
        if (n.whole == whole && n.list > best.list) best = {alpha, whole, n.list, n.staging};
      }
    }
    return best;
  }
  void note_need(const Need& need) {
    for (Need& n : needs) {
      if (n.whole == need.whole && n.alpha == need.alpha) {
        n = need;
        return;
      }
    }
    if (needs.size() >= 64) needs.erase(needs.begin());
    needs.push_back(need);
  }

  void scan(const std::uint32_t* in, std::uint32_t* out, std::size_t count) {
    std::size_t bytes = 0;
    check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, in, out, static_cast<int>(count), stream), "sizing a prefix sum");
    scratch.reserve(bytes);
    check(cub::DeviceScan::ExclusiveSum(scratch.get(), bytes, in, out, static_cast<int>(count), stream), "a prefix sum");
  }
  void zero(void* data, std::size_t bytes) {
    check(cudaMemsetAsync(data, 0, bytes, stream), "clearing device memory");
  }
  template <int N>
  DeviceSimplices<N> device_simplices(bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    return {d.vertices.get(),
            whole ? d.value.get() : nullptr,
            whole ? d.simplex_class.get() : nullptr,
            static_cast<std::uint32_t>(d.simplices(N, whole)),
            &counters.get()->cursor[N - 2],
            d.start.get(),
            d.count.get()};
  }
  template <int N>
  void order(bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    scan(d.count.get(), d.offset.get(), n);
    place<N><<<4 * multiprocessors, kThreads, 0, stream>>>(
        device_simplices<N>(whole), d.offset.get(), d.ordered.get(),
        whole ? d.ordered_value.get() : nullptr, whole ? d.ordered_class.get() : nullptr);
  }
  // Brings `count` simplices to the host.
  template <int N>
  HostSimplices<N> fetch(std::size_t count, bool whole) {
    DimensionBuffers& d = dimension[N - 1];
    d.host_vertices.reserve(count * N + count * N / 8);
    check(cudaMemcpyAsync(d.host_vertices.get(), d.ordered.get(), count * N * 4, cudaMemcpyDeviceToHost, stream), "copying simplices");
    HostSimplices<N> result;
    static_assert(sizeof(std::array<BallIndex, N>) == N * sizeof(std::uint32_t));
    result.simplices = {reinterpret_cast<const std::array<BallIndex, N>*>(d.host_vertices.get()), count};
    if (whole) {
      d.host_value.reserve(count + count / 8);
      d.host_class.reserve(count + count / 8);
      check(cudaMemcpyAsync(d.host_value.get(), d.ordered_value.get(), count * 4, cudaMemcpyDeviceToHost, stream), "copying alpha values");
      check(cudaMemcpyAsync(d.host_class.get(), d.ordered_class.get(), count, cudaMemcpyDeviceToHost, stream), "copying classes");
      result.values = {d.host_value.get(), count};
      result.classes = {reinterpret_cast<const SimplexClass*>(d.host_class.get()), count};
    }
    return result;
  }
};

FacetPipeline::FacetPipeline(const BallSet& balls) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.n = balls.size();
  int device = 0;
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaDeviceGetAttribute(&s.shared_limit, cudaDevAttrMaxSharedMemoryPerBlockOptin, device), "asking for its shared memory");
  check(cudaDeviceGetAttribute(&s.multiprocessors, cudaDevAttrMultiProcessorCount, device), "asking for its processors");
  check(cudaStreamCreateWithFlags(&s.stream, cudaStreamNonBlocking), "creating a stream");
  const std::vector<bool> hidden = coincident_hidden(balls);
  s.host_balls.reserve(std::max<std::size_t>(s.n, 1));
  s.low = s.high = s.n == 0 ? LatticePoint{} : balls.centres[0];
  s.max_radius = s.n == 0 ? 1 : balls.radii[0];
  for (BallIndex i = 0; i < s.n; ++i) {
    const LatticePoint& c = balls.centres[i];
    const bool dead = !hidden.empty() && hidden[i];
    s.host_balls.get()[i] = make_int4(c.x, c.y, c.z, dead ? -1 : balls.radii[i]);
    s.low = {std::min(s.low.x, c.x), std::min(s.low.y, c.y), std::min(s.low.z, c.z)};
    s.high = {std::max(s.high.x, c.x), std::max(s.high.y, c.y), std::max(s.high.z, c.z)};
    s.max_radius = std::max(s.max_radius, balls.radii[i]);
  }
  s.host_counters.reserve(1);
  s.counters.reserve(1);
  s.balls.reserve(s.n);
  s.sorted.reserve(s.n);
  s.cell_and_rank.reserve(s.n);
  s.index.reserve(s.n);
  s.reach.reserve(s.n);
  s.exact_list.reserve(s.n);
}

FacetPipeline::~FacetPipeline() = default;

PipelineResult FacetPipeline::run(double alpha, bool tetrahedra_only, const CancelToken& cancel,
                                  StageTimes* times) {
  State& s = *state_;
  const bool whole = !tetrahedra_only;
  PipelineResult result;
  const double largest = static_cast<double>(s.max_radius) * s.max_radius + alpha;
  if (s.n == 0 || largest < 0) return result;
  const double cutoff = 2 * std::sqrt(largest);
  if (!(cutoff < kMaxCutoff)) {
    result.fits = false;
    return result;
  }

  Problem p{};
  p.ball_count = static_cast<int>(s.n);
  p.alpha = alpha;
  p.scale = static_cast<float>(std::ldexp(1.0, -static_cast<int>(std::ceil(std::log2(std::max(cutoff, 2.0))))));
  p.ghost_reach = 4;
  while (static_cast<double>(p.ghost_reach) < std::sqrt(largest) + 2) p.ghost_reach *= 2;
  p.origin = make_int4(s.low.x, s.low.y, s.low.z, 0);
  double width = std::ceil(cutoff * (1 + 1e-5)) + 2;
  const auto cells = [&](std::int32_t low, std::int32_t high) {
    return std::floor((static_cast<double>(high) - low) / width) + 1;
  };
  while (cells(s.low.x, s.high.x) * cells(s.low.y, s.high.y) * cells(s.low.z, s.high.z) > 4.0 * static_cast<double>(s.n) + 64) {
    width = std::ceil(width * 1.25);
  }
  p.cell_width = static_cast<int>(width);
  p.nx = static_cast<int>(cells(s.low.x, s.high.x));
  p.ny = static_cast<int>(cells(s.low.y, s.high.y));
  p.nz = static_cast<int>(cells(s.low.z, s.high.z));
  const std::size_t cell_count = static_cast<std::size_t>(p.nx) * p.ny * p.nz + 1;  // and the dead
  s.cell_count.reserve(cell_count + 1);
  s.cell_start.reserve(cell_count + 1);
  for (int d = 1; d < 4; ++d) {
    if (!whole && d < 3) continue;
    s.dimension[d].start.reserve(s.n);
    s.dimension[d].count.reserve(s.n);
    s.dimension[d].offset.reserve(s.n);
    s.dimension[d].reserve(std::max<std::size_t>(s.n * (d == 3 ? 3 : 6), 1024), d + 1, whole);
  }
  if (whole) {
    s.vertex_state.reserve(s.n);
    s.flags.reserve(s.n);
    s.nearest.reserve(s.n);
    s.present.reserve(s.n);
    s.dimension[0].offset.reserve(s.n + 1);
    s.dimension[0].reserve(s.n, 1, true);
  }

  EventTimer timer(s.stream, times);
  State::Need need = s.expected_need(alpha, whole);
  for (int attempt = 0;; ++attempt) {
    cancel.throw_if_cancelled();
    // As many balls a block as its memory comfortably holds, but blocks for all multiprocessors.
    p.list_capacity = (need.list + 7) / 8 * 8;
    const int fair = static_cast<int>(s.n / (static_cast<std::size_t>(s.multiprocessors) * 4));
    p.balls_per_block = std::clamp(std::min(1024 / p.list_capacity, fair), 1, kMaxBallsPerBlock);
    p.staging_capacity = need.staging * p.balls_per_block;
    p.tile = s.n > kManyBalls ? 4 : 8;
    Problem exact = p;
    exact.balls_per_block = 1;
    const std::size_t shared = block_memory_bytes(p, whole);
    const std::size_t shared_exact = block_memory_bytes(exact, whole);
    if (shared > static_cast<std::size_t>(s.shared_limit) || p.list_capacity > kMaxList) {
      result.fits = false;
      return result;
    }

    timer.restart();
    check(cudaMemcpyAsync(s.balls.get(), s.host_balls.get(), s.n * sizeof(int4), cudaMemcpyHostToDevice, s.stream), "copying the balls");
    timer.mark(stage::kHostToDevice);

    s.zero(s.cell_count.get(), (cell_count + 1) * 4);
    s.zero(s.counters.get(), sizeof(Counters));
    assign_cells<<<blocks_for(s.n), kThreads, 0, s.stream>>>(p, s.balls.get(), s.cell_count.get(), s.cell_and_rank.get());
    s.scan(s.cell_count.get(), s.cell_start.get(), cell_count + 1);
    sort_into_cells<<<blocks_for(s.n), kThreads, 0, s.stream>>>(p, s.balls.get(), s.cell_and_rank.get(), s.cell_start.get(), s.sorted.get(), s.index.get(), s.reach.get());
    timer.mark(stage::kGrid);

    const SortedBalls sorted{s.sorted.get(), s.index.get(), s.reach.get(), s.cell_start.get(),
                             s.cell_start.get() + (cell_count - 1)};
    Counters* c = s.counters.get();
    const Output out{s.device_simplices<2>(whole), s.device_simplices<3>(whole), s.device_simplices<4>(whole),
                     s.vertex_state.get(), s.exact_list.get(), &c->exact_count, &c->needed_list,
                     &c->needed_staging, &c->failures};
    for (int d = whole ? 1 : 3; d < 4; ++d) s.zero(s.dimension[d].count.get(), s.n * 4);
    if (whole) s.zero(s.vertex_state.get(), s.n);
    const unsigned blocks = static_cast<unsigned>((s.n + p.balls_per_block - 1) / p.balls_per_block);
    const auto launch = [&](auto kernel, unsigned grid, const Problem& problem, std::size_t bytes) {
      check(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(bytes)), "preparing a kernel");
      kernel<<<grid, kBlockThreads, bytes, s.stream>>>(problem, sorted, out);
      check(cudaGetLastError(), "starting a kernel");
    };
    launch(whole ? facets_filtered<true> : facets_filtered<false>, blocks, p, shared);
    timer.mark(stage::kCandidatesAndFiltered);
    const unsigned exact_blocks = static_cast<unsigned>(2 * s.multiprocessors);
    launch(whole ? facets_exact<true> : facets_exact<false>, exact_blocks, exact, shared_exact);
    timer.mark(stage::kExactValidity);

    if (whole) {
      s.order<2>(true);
      s.order<3>(true);
    }
    s.order<4>(whole);
    if (whole) {
      s.zero(s.flags.get(), s.n * 4);
      check(cudaMemsetAsync(s.nearest.get(), 0xff, s.n * 4, s.stream), "clearing device memory");
      gather_vertices<<<4 * s.multiprocessors, kThreads, 0, s.stream>>>(
          s.dimension[1].ordered.get(), s.dimension[1].ordered_value.get(), s.dimension[1].ordered_class.get(),
          &c->cursor[0], static_cast<std::uint32_t>(s.dimension[1].simplices(2, true)), s.vertex_state.get(), s.flags.get(), s.nearest.get());
      mark_vertices<<<blocks_for(s.n), kThreads, 0, s.stream>>>(p.ball_count, s.vertex_state.get(), s.flags.get(), s.present.get());
      s.scan(s.present.get(), s.dimension[0].offset.get(), s.n);
      place_vertices<<<blocks_for(s.n), kThreads, 0, s.stream>>>(
          p.ball_count, s.balls.get(), s.vertex_state.get(), s.flags.get(), s.nearest.get(), s.present.get(),
          s.dimension[0].offset.get(), s.dimension[0].ordered.get(), s.dimension[0].ordered_value.get(), s.dimension[0].ordered_class.get());
    }
    check(cudaMemcpyAsync(s.host_counters.get(), c, sizeof(Counters), cudaMemcpyDeviceToHost, s.stream), "copying the counts");
    std::uint32_t vertex_tail[2] = {0, 0};
    if (whole) {
      check(cudaMemcpyAsync(&vertex_tail[0], s.present.get() + s.n - 1, 4, cudaMemcpyDeviceToHost, s.stream), "copying the counts");
      check(cudaMemcpyAsync(&vertex_tail[1], s.dimension[0].offset.get() + s.n - 1, 4, cudaMemcpyDeviceToHost, s.stream), "copying the counts");
    }
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
    for (int d = whole ? 1 : 3; d < 4; ++d) {
      const std::size_t count = got.cursor[d - 1];
      if (count > s.dimension[d].simplices(d + 1, whole)) {
        s.dimension[d].reserve(count + count / 8, d + 1, whole);
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

    s.note_need({alpha, whole, std::max(8, static_cast<int>(got.needed_list)), need.staging});
    cancel.throw_if_cancelled();
    result.exact_balls = got.exact_count;
    if (whole) {
      result.vertices = s.fetch<1>(vertex_tail[0] + vertex_tail[1], true);
      result.edges = s.fetch<2>(got.cursor[0], true);
      result.triangles = s.fetch<3>(got.cursor[1], true);
    }
    result.tetrahedra = s.fetch<4>(got.cursor[2], whole);
    timer.mark(stage::kDeviceToHost);
    check(cudaStreamSynchronize(s.stream), "copying the result");
    timer.report();
    return result;
  }
}

}  // namespace alphascope::gpu
