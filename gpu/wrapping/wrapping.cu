// SPDX-License-Identifier: GPL-3.0-or-later
// Completes a triangulation on the device: memory, copies and the order of kernels.
#include "gpu/wrapping/wrapping.hpp"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/geometry/ball_set.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/wrapping/front_search.cuh"

namespace alphascope::gpu {

namespace {

constexpr unsigned kEachThreads = 256;
constexpr int kRoundsAtOnce = 8;

class Timer {
 public:
  explicit Timer(cudaStream_t stream) : stream_(stream) {
    begin_.create(cudaEventDefault);
    end_.create(cudaEventDefault);
    begin_.record(stream_);
  }
  void stop() { end_.record(stream_); }
  double milliseconds() {
    check(cudaEventSynchronize(end_), "timing");
    float ms = 0;
    check(cudaEventElapsedTime(&ms, begin_, end_), "timing");
    return static_cast<double>(ms);
  }

 private:
  cudaStream_t stream_;
  Event begin_, end_;
};

}  // namespace

struct Wrapping::State {
  Stream stream;
  std::uint32_t n = 0;
  int multiprocessors = 1;
  DeviceBuffer<int4> arrived, balls, tree_balls;
  DeviceBuffer<std::uint64_t> code, code_sorted;
  DeviceBuffer<std::uint32_t> index, index_sorted;  // index_sorted: the ball of each slot
  DeviceBuffer<std::uint32_t> slot;                 // of each ball
  DeviceBuffer<std::uint32_t> needed, found, place, tree_slot;
  DeviceBuffer<float4> low, high;
  DeviceBuffer<unsigned char> scratch;
  DeviceBuffer<std::uint32_t> vertices;
  DeviceBuffer<Quad> quads;
  DeviceBuffer<FaceRef> neighbours, known_table, table, queue;
  DeviceBuffer<std::uint32_t> apex, unsure;
  DeviceBuffer<FrontCounts> counts;
  PinnedBuffer<FrontCounts> host_counts;
  PinnedBuffer<std::uint32_t> host_number;
  PinnedBuffer<Quad> host_quads;
  std::vector<BallIndex> ball_of_slot;
  int4 origin{};
  float scale = 1, weight = 0;
  double order_ms = 0;

  template <class Kernel, class... Arguments>
  void each(Kernel kernel, std::size_t items, const Arguments&... arguments) {
    if (items == 0) return;
    const auto blocks = static_cast<unsigned>((items + kEachThreads - 1) / kEachThreads);
    launch(kernel, {blocks, kEachThreads, stream}, arguments...);
    check(cudaGetLastError(), "starting a kernel");
  }
  template <class T>
  void fill(const DeviceBuffer<T>& to, int byte, std::size_t count) {
    check(cudaMemsetAsync(to.get(), byte, count * sizeof(T), stream), "clearing device memory");
  }
  void wait(const char* what) { check(cudaStreamSynchronize(stream), what); }

  void load(const BallSet& set);
  BallTree grow_tree();
  FrontCounts read_counts() {
    check(cudaMemcpyAsync(host_counts.get(), counts.get(), sizeof(FrontCounts),
                          cudaMemcpyDeviceToHost, stream),
          "copying counts");
    wait("completing a triangulation");
    return *host_counts.get();
  }
};

void Wrapping::State::load(const BallSet& set) {
  n = static_cast<std::uint32_t>(set.size());
  LatticePoint least = set.centres[0], most = set.centres[0];
  std::int32_t radius = 0;
  std::vector<int4> host(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    const LatticePoint& p = set.centres[i];
    host[i] = make_int4(p.x, p.y, p.z, set.radii[i]);
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    radius = std::max(radius, set.radii[i]);
  }
  origin = make_int4(least.x, least.y, least.z, 0);
  const auto extent = static_cast<std::uint32_t>(
      std::max({most.x - least.x, most.y - least.y, most.z - least.z, 1}));
  const int bits = std::bit_width(extent);
  scale = std::ldexp(1.0f, 12 - bits);
  weight = static_cast<float>(radius) * scale;
  weight *= weight * 1.00001f;

  arrived.reserve(n);
  balls.reserve(n);
  code.reserve(n);
  code_sorted.reserve(n);
  index.reserve(n);
  index_sorted.reserve(n);
  slot.reserve(n);
  check(
      cudaMemcpyAsync(arrived.get(), host.data(), n * sizeof(int4), cudaMemcpyHostToDevice, stream),
      "sending the balls");
  wait("sending the balls");
  Timer timer(stream);
  // Some 16 cells for each ball suffice for an order.
  const int per_axis = std::min({21, bits, static_cast<int>(std::bit_width(n)) / 3 + 3});
  each(find_codes, n, arrived.get(), n, origin, bits - per_axis, code.get(), index.get());
  std::size_t bytes = 0;
  const auto sort = [&](void* memory) {
    check(cub::DeviceRadixSort::SortPairs(memory, bytes, code.get(), code_sorted.get(), index.get(),
                                          index_sorted.get(), static_cast<int>(n), 0, 3 * per_axis,
                                          stream),
          "sorting the balls");
  };
  sort(nullptr);
  scratch.reserve(bytes);
  sort(scratch.get());
  each(gather_balls, n, arrived.get(), index_sorted.get(), n, balls.get(), slot.get());
  timer.stop();
  order_ms = timer.milliseconds();
  ball_of_slot.resize(n);
  check(cudaMemcpyAsync(ball_of_slot.data(), index_sorted.get(), n * sizeof(std::uint32_t),
                        cudaMemcpyDeviceToHost, stream),
        "copying an order");
  wait("copying an order");
}

// The tree of the balls that `needed` marks.
BallTree Wrapping::State::grow_tree() {
  place.reserve(n + 1);
  prefix_sum(needed.get(), place.get(), n + 1, scratch, stream);
  host_number.reserve(1);
  check(cudaMemcpyAsync(host_number.get(), place.get() + n, sizeof(std::uint32_t),
                        cudaMemcpyDeviceToHost, stream),
        "copying a count");
  wait("counting balls");
  const std::uint32_t count = *host_number.get();
  BallTree tree{};
  const std::uint32_t boxes = set_levels(tree, count);
  tree_balls.reserve(count);
  tree_slot.reserve(count);
  low.reserve(boxes);
  high.reserve(boxes);
  tree.ball = tree_balls.get();
  tree.slot = tree_slot.get();
  tree.boxes = {low.get(), high.get()};
  tree.origin = origin;
  tree.scale = scale;
  each(gather_needed, n, balls.get(), needed.get(), place.get(), n, tree_balls.get(),
       tree_slot.get());
  each(box_leaves, tree.count[0], tree);
  for (int level = 1; level <= tree.top; ++level) each(box_level, tree.count[level], tree, level);
  return tree;
}

Wrapping::Wrapping(const BallSet& balls) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.stream.create();
  int device = 0;
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaDeviceGetAttribute(&s.multiprocessors, cudaDevAttrMultiProcessorCount, device),
        "asking for the device");
  s.load(balls);
}

Wrapping::~Wrapping() {
  cudaStreamSynchronize(state_->stream);
}

WrappingResult Wrapping::run(std::span<const std::array<BallIndex, 4>> known, std::size_t room,
                             bool bring, const CancelToken& cancel, bool timed) {
  State& s = *state_;
  WrappingResult result;
  result.known = known.size();
  result.order_ms = s.order_ms;
  const auto count = static_cast<std::uint32_t>(known.size());
  const std::size_t all = known.size() + room, queue_room = 3 * room + 4 * known.size();
  s.vertices.reserve(4 * known.size());
  s.quads.reserve(all);
  s.neighbours.reserve(4 * all);
  s.queue.reserve(queue_room);
  s.apex.reserve(queue_room);
  s.unsure.reserve(queue_room);
  s.counts.reserve(1);
  s.host_counts.reserve(1);
  s.needed.reserve(s.n + 1);
  s.found.reserve(s.n);
  const std::size_t known_entries = std::bit_ceil(6 * known.size() + 16);
  s.known_table.reserve(known_entries);
  check(cudaMemcpyAsync(s.vertices.get(), known.data(), known.size_bytes(), cudaMemcpyHostToDevice,
                        s.stream),
        "sending tetrahedra");
  s.fill(s.counts, 0, 1);
  s.fill(s.neighbours, 0xff, 4 * all);
  s.fill(s.known_table, 0xff, known_entries);
  s.fill(s.needed, 0, s.n + 1);
  s.fill(s.found, 0, s.n);

  const Faces faces{s.quads.get(), s.neighbours.get()};
  Timer opening(s.stream);
  s.each(read_quads, count, s.vertices.get(), count, s.slot.get(), s.balls.get(), s.quads.get());
  s.each(join_faces, 4 * known.size(), faces,
         FaceTable{s.known_table.get(), static_cast<std::uint32_t>(known_entries - 1)}, count);
  s.each(mark_found, count, s.quads.get(), count, s.found.get());
  s.each(add_unfound, s.n, s.found.get(), s.n, s.needed.get());
  opening.stop();
  // Faces that are open at once, and those that were, stay in the table.
  const std::size_t entries = std::bit_ceil(3 * room + 4 * known.size() / 2 + 1024);
  s.table.reserve(entries);
  s.fill(s.table, 0xff, entries);
  const Front front{faces,
                    {s.table.get(), static_cast<std::uint32_t>(entries - 1)},
                    s.queue.get(),
                    s.apex.get(),
                    s.unsure.get(),
                    static_cast<std::uint32_t>(all),
                    static_cast<std::uint32_t>(std::min(queue_room, entries / 8 * 7)),
                    s.counts.get()};
  Timer queueing(s.stream);
  s.each(queue_open_faces, 4 * known.size(), front, count, s.needed.get());
  queueing.stop();
  FrontCounts counts = s.read_counts();
  result.open = counts.tail;
  counts.quads = counts.quads_before = count;
  *s.host_counts.get() = counts;
  check(cudaMemcpyAsync(s.counts.get(), s.host_counts.get(), sizeof(FrontCounts),
                        cudaMemcpyHostToDevice, s.stream),
        "sending counts");
  Timer growing(s.stream);
  const BallTree tree = s.grow_tree();
  growing.stop();
  result.needed = tree.balls;
  result.open_ms = opening.milliseconds() + queueing.milliseconds();
  result.tree_ms = growing.milliseconds();

  Timer wrapping(s.stream);
  const unsigned blocks = 8u * static_cast<unsigned>(s.multiprocessors);
  double search_ms = 0;
  for (;;) {
    cancel.throw_if_cancelled();
    for (int round = 0; round < (timed ? 1 : kRoundsAtOnce); ++round) {
      launch(begin_round, {1, 32, s.stream}, s.counts.get());
      Timer searching(s.stream);
      launch(search_faces<float>, {blocks, kSearchThreads, s.stream}, front, tree, s.balls.get(),
             s.place.get(), s.weight);
      launch(search_faces<double>, {blocks, kSearchThreads, s.stream}, front, tree, s.balls.get(),
             s.place.get(), s.weight);
      searching.stop();
      launch(extend_front, {4 * blocks, kEachThreads, s.stream}, front);
      check(cudaGetLastError(), "starting a kernel");
      if (timed) search_ms += searching.milliseconds();
    }
    counts = s.read_counts();
    if (counts.full != 0 || counts.end == counts.tail) break;
  }
  wrapping.stop();
  result.front_ms = wrapping.milliseconds();
  result.search_ms = search_ms;
  result.rounds = counts.rounds;
  result.searched = counts.end;
  result.exact = counts.exact;
  result.hull = counts.hull;
  result.fits = counts.full == 0;
  if (!bring || !result.fits) return result;
  const std::size_t new_quads = counts.quads - count;
  s.host_quads.reserve(new_quads);
  check(cudaMemcpyAsync(s.host_quads.get(), s.quads.get() + count, new_quads * sizeof(Quad),
                        cudaMemcpyDeviceToHost, s.stream),
        "copying tetrahedra");
  s.wait("copying tetrahedra");
  result.found.resize(new_quads);
  for (std::size_t t = 0; t < new_quads; ++t) {
    const Quad& q = s.host_quads.get()[t];
    auto& to = result.found[t];
    to = {s.ball_of_slot[q.x & ~kNegative], s.ball_of_slot[q.y], s.ball_of_slot[q.z],
          s.ball_of_slot[q.w]};
    std::sort(to.begin(), to.end());
  }
  return result;
}

}  // namespace alphascope::gpu
