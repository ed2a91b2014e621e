// SPDX-License-Identifier: GPL-3.0-or-later
// Completes a triangulation on the device: memory, copies and the order of kernels.
#include "gpu/wrapping/wrapping.hpp"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/geometry/ball_set.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/wrapping/near_search.cuh"
#include "gpu/wrapping/tree_search.cuh"
#include "gpu/wrapping/wide_search.cuh"

namespace alphascope::gpu {

namespace {

constexpr unsigned kEachThreads = 256;
constexpr int kRoundsAtOnce = 8;
constexpr double kCellsPerGuess = 1.3;  // width of a cell in guessed radii

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

static_assert(WrappingResult::kSearches == kSearches);

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
  DeviceBuffer<std::uint32_t> apex, list[kSearches];  // list: see FrontCounts::listed
  struct GridMemory {
    DeviceBuffer<int4> ball;
    DeviceBuffer<std::uint32_t> slot, start, cell, rank;
  } grid;
  DeviceBuffer<Candidates> candidates;
  DeviceBuffer<float> bounds;
  DeviceBuffer<std::uint32_t> wide_nodes;
  DeviceBuffer<FrontCounts> counts;
  PinnedBuffer<FrontCounts> host_counts;
  PinnedBuffer<std::uint32_t> host_number;
  PinnedBuffer<Quad> host_quads;
  std::vector<BallIndex> ball_of_slot;
  int4 origin{};
  std::int32_t extent[3] = {0, 0, 0};
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
  NearGrid make_grid(const BallTree& tree, double width);
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
  extent[0] = most.x - least.x;
  extent[1] = most.y - least.y;
  extent[2] = most.z - least.z;
  const int bits =
      std::bit_width(static_cast<std::uint32_t>(std::max({extent[0], extent[1], extent[2], 1})));
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

// A grid of the tree's balls. Its cells have this width (lattice units), or a larger one if there
// would be too many.
NearGrid Wrapping::State::make_grid(const BallTree& tree, double width) {
  GridMemory& memory = this->grid;
  NearGrid grid{};
  const double most = 8.0 * tree.balls + 4096;
  for (;; width *= 1.25) {
    grid.width = static_cast<int>(std::clamp(width, 1.0, 1e9));
    grid.nx = extent[0] / grid.width + 1;
    grid.ny = extent[1] / grid.width + 1;
    grid.nz = extent[2] / grid.width + 1;
    if (1.0 * grid.nx * grid.ny * grid.nz <= most) break;
  }
  grid.scaled_width = static_cast<float>(grid.width) * scale;
  grid.inverse_width = 1 / grid.scaled_width;
  const std::size_t cells = grid.cells();
  memory.ball.reserve(tree.balls);
  memory.slot.reserve(tree.balls);
  memory.cell.reserve(tree.balls);
  memory.rank.reserve(tree.balls);
  memory.start.reserve(cells + 1);
  grid.ball = memory.ball.get();
  grid.slot = memory.slot.get();
  grid.start = memory.start.get();
  grid.cell = memory.cell.get();
  grid.rank = memory.rank.get();
  fill(memory.start, 0, cells + 1);
  each(count_cells, tree.balls, tree, grid);
  prefix_sum(memory.start.get(), memory.start.get(), cells + 1, scratch, stream);
  each(fill_cells, tree.balls, tree, grid);
  return grid;
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

WrappingResult Wrapping::run(std::span<const std::array<BallIndex, 4>> known, double radius,
                             std::size_t room, bool bring, const CancelToken& cancel, bool timed) {
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
  s.apex.reserve(4 * all);
  for (auto& list : s.list) list.reserve(queue_room);
  s.counts.reserve(1);
  s.host_counts.reserve(1);
  s.needed.reserve(s.n + 1);
  s.found.reserve(s.n);
  const std::size_t known_entries = 5 * known.size() + 16;
  s.known_table.reserve(known_entries);
  check(cudaMemcpyAsync(s.vertices.get(), known.data(), known.size_bytes(), cudaMemcpyHostToDevice,
                        s.stream),
        "sending tetrahedra");
  s.fill(s.counts, 0, 1);
  s.fill(s.neighbours, 0xff, 4 * all);
  s.fill(s.apex, 0xff, 4 * all);
  s.fill(s.known_table, 0xff, known_entries);
  s.fill(s.needed, 0, s.n + 1);
  s.fill(s.found, 0, s.n);

  const Faces faces{s.quads.get(), s.neighbours.get()};
  Timer opening(s.stream);
  s.each(read_quads, count, s.vertices.get(), count, s.slot.get(), s.balls.get(), s.quads.get());
  s.each(join_faces, 4 * known.size(), faces,
         FaceTable{s.known_table.get(), static_cast<std::uint32_t>(known_entries)}, count);
  s.each(mark_found, count, s.quads.get(), count, s.found.get());
  s.each(add_unfound, s.n, s.found.get(), s.n, s.needed.get());
  opening.stop();
  // Faces stay in the table. A new tetrahedron opens 1.7 faces on average, and a known one of a
  // molecule half a face.
  const std::size_t entries = room * 5 / 2 + known.size() * 3 / 4 + 1024;
  s.table.reserve(entries);
  s.fill(s.table, 0xff, entries);
  const Front front{faces,
                    {s.table.get(), static_cast<std::uint32_t>(entries)},
                    s.queue.get(),
                    s.apex.get(),
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
  const NearGrid grid = s.make_grid(tree, kCellsPerGuess * radius);
  growing.stop();
  result.needed = tree.balls;
  result.open_ms = opening.milliseconds() + queueing.milliseconds();
  result.tree_ms = growing.milliseconds();

  Timer wrapping(s.stream);
  const unsigned blocks = 8u * static_cast<unsigned>(s.multiprocessors);
  const auto list = [&](Search of) {
    return SearchList{s.list[of].get(), &s.counts.get()->listed[of]};
  };
  const auto task = [&](Search of) {
    return SearchTask{s.list[of].get(), &s.counts.get()->listed[of], &s.counts.get()->next[of]};
  };
  s.candidates.reserve(queue_room);
  s.bounds.reserve(queue_room);
  const auto wide_blocks = static_cast<unsigned>(s.multiprocessors);
  s.wide_nodes.reserve(std::size_t{2} * kWideNodes * wide_blocks);
  const SearchSpace space{tree,        s.balls.get(),   s.place.get(),
                          s.weight,    list(kDoubtful), s.candidates.get(),
                          list(kWide), s.bounds.get(),  list(kExact)};
  const LaunchShape searching{blocks, kSearchThreads, s.stream};
  const float guess = static_cast<float>(radius) * s.scale;
  for (;;) {
    cancel.throw_if_cancelled();
    for (int round = 0; round < (timed ? 1 : kRoundsAtOnce); ++round) {
      std::optional<Timer> timer;
      WrappingResult::Round times;
      const auto next = [&](int search) {
        if (!timed) return;
        if (timer) {
          timer->stop();
          times.milliseconds[static_cast<std::size_t>(search)] = timer->milliseconds();
        }
        timer.emplace(s.stream);
      };
      launch(begin_round, {1, 32, s.stream}, s.counts.get());
      next(0);
      launch(search_near, searching, front, space, grid, guess, &s.counts.get()->next[kNear],
             list(kFar));
      next(kNear);
      launch(search_tree<false>, searching, front, space, task(kFar));
      next(kFar);
      launch(search_widely, {wide_blocks, kWideThreads, s.stream}, front, space, task(kWide),
             s.wide_nodes.get());
      next(kWide);
      launch(decide_faces, {blocks, kSearchThreads, s.stream}, front, s.balls.get(),
             list(kDoubtful), s.candidates.get());
      next(kDoubtful);
      launch(search_tree<true>, searching, front, space, task(kExact));
      next(kExact);
      launch(extend_front, {4 * blocks, kEachThreads, s.stream}, front);
      next(kSearches);
      check(cudaGetLastError(), "starting a kernel");
      if (!timed) continue;
      counts = s.read_counts();
      std::copy_n(counts.listed, +kSearches, times.faces.begin());
      result.timed.push_back(times);
    }
    counts = s.read_counts();
    if (counts.full != 0 || counts.end == counts.tail) break;
  }
  wrapping.stop();
  result.front_ms = wrapping.milliseconds();
  result.rounds = counts.rounds;
  for (std::size_t search = 0; search < kSearches; ++search)
    result.searched[search] = counts.all[search] + counts.listed[search];
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
