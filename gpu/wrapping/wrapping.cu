// SPDX-License-Identifier: GPL-3.0-or-later
// Completes a triangulation on the device: memory, copies and the order of kernels.
#include "gpu/wrapping/wrapping.hpp"

#include <cub/device/device_radix_sort.cuh>

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>
#include <optional>

#include "core/geometry/ball_set.hpp"
#include "core/run/parallel.hpp"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/memory/work_stream.cuh"
#include "gpu/wrapping/decide_kernel.cuh"
#include "gpu/wrapping/front_kernels.cuh"
#include "gpu/wrapping/hidden_kernels.cuh"
#include "gpu/wrapping/near_search.cuh"
#include "gpu/wrapping/tree_kernels.cuh"
#include "gpu/wrapping/tree_search.cuh"
#include "gpu/wrapping/wide_search.cuh"
#include "gpu/wrapping/wrapped.cuh"

namespace alphascope::gpu {

namespace {

constexpr int kRoundsAtOnce = 8;
constexpr double kCellsPerGuess = 1.3;  // width of a cell in guessed radii
// How far a ball that is not in a known tetrahedron looks for one to begin a walk, in slots, and
// the length of the walk.
constexpr std::uint32_t kEarlyReach = 256, kEarlySteps = 64;

}  // namespace

static_assert(WrappingResult::kSearches == kSearches);
static_assert(Wrapping::kMost == kMaxTreeBalls);

// Numbers of elements for which there is room.
struct Rooms {
  std::size_t known, quads, queue;
  std::size_t buckets, known_buckets;  // of the tables of faces, for the front and for the known

  // Faces stay in the table. A new tetrahedron opens 1.7 faces on average, and a known one of a
  // molecule half a face.
  Rooms(std::size_t known_quads, std::size_t new_quads)
      : known(known_quads),
        quads(known_quads + new_quads),
        queue((new_quads * 5 / 2 + known_quads * 3 / 4 + 1024) / 8 * 7),
        buckets((new_quads * 3 + known_quads + 1024) / kBucket),
        known_buckets((5 * known_quads + 16) / kBucket) {}
};

struct Wrapping::State {
  WorkStream stream;
  std::uint32_t n = 0;
  int multiprocessors = 1;
  DeviceBuffer<int4> arrived, balls, shown, tree_balls;
  DeviceBuffer<std::uint64_t> code, code_sorted;
  DeviceBuffer<std::uint32_t> index, index_sorted;  // index_sorted: the ball of each slot
  DeviceBuffer<std::uint32_t> slot;                 // of each ball
  DeviceBuffer<std::uint32_t> needed, found, place, tree_slot;
  DeviceBuffer<float4> box_low, box_high;
  DeviceBuffer<unsigned char> scratch;
  DeviceBuffer<std::uint32_t> vertices;
  DeviceBuffer<Quad> quads;
  DeviceBuffer<FaceRef> neighbours, queue;
  DeviceBuffer<FaceEntry> known_table, table;
  DeviceBuffer<std::uint32_t> apex, lists[kSearches];  // see FrontCounts::listed
  struct GridMemory {
    DeviceBuffer<int4> ball;
    DeviceBuffer<std::uint32_t> slot, start, cell, rank;
  } grid_memory;
  DeviceBuffer<Candidates> candidates;
  DeviceBuffer<float> far_bounds, bounds, gaps;
  DeviceBuffer<std::uint32_t> wide_nodes;
  DeviceBuffer<FrontCounts> counts;
  PinnedBuffer<FrontCounts> host_counts;
  PinnedBuffer<std::uint32_t> host_number;
  PinnedBuffer<Quad> host_quads;
  PinnedBuffer<int4> host_balls;
  // Targets of copies are members, because a copy may still come after a failure.
  PinnedBuffer<float> host_gaps;
  PinnedBuffer<BallIndex> host_index;
  Lattice lattice;
  LatticePoint low, high;
  std::int32_t max_radius = 1;
  int4 origin{};
  std::int32_t extent[3] = {0, 0, 0};
  float scale = 1, weight = 0;
  bool small = false;
  double order_ms = 0;
  Wrapped wrapped;

  void load(const BallSet& set);
  void reserve(const Rooms& rooms);
  Front find_open_faces(const BallIndex* known, const Rooms& rooms, WrappingResult& result);
  BallTree grow_tree();
  NearGrid make_grid(const BallTree& tree, double width);
  SearchList list(Search of) { return {lists[of].get(), &counts.get()->listed[of]}; }
  SearchTask task(Search of) {
    const float* const known = of == kFar ? far_bounds.get() : of == kWide ? bounds.get() : nullptr;
    return {lists[of].get(), known, &counts.get()->listed[of], &counts.get()->next[of]};
  }
  void search_round(const Front& front, const SearchSpace& space, const NearGrid& grid, float guess,
                    WrappingResult::Round* times);
  void bring(std::size_t known, std::size_t all, WrappingResult& result);
  FrontCounts read_counts() {
    stream.fetch(host_counts.get(), counts.get(), 1);
    stream.wait("completing a triangulation");
    return *host_counts.get();
  }
};

void Wrapping::State::load(const BallSet& set) {
  n = static_cast<std::uint32_t>(set.size());
  host_balls.reserve(n);
  lattice = set.lattice;
  low = high = set.centres[0];
  max_radius = set.radii[0];
  std::mutex mutex;
  constexpr std::size_t kGrain = 1 << 15;
  parallel_ranges(std::uint32_t{0}, n, kGrain, [&](std::uint32_t begin, std::uint32_t end) {
    LatticePoint least = set.centres[begin], most = least;
    std::int32_t largest = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      const LatticePoint& p = set.centres[i];
      host_balls.get()[i] = make_int4(p.x, p.y, p.z, set.radii[i]);
      least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
      largest = std::max(largest, set.radii[i]);
    }
    const std::lock_guard lock(mutex);
    low = {std::min(low.x, least.x), std::min(low.y, least.y), std::min(low.z, least.z)};
    high = {std::max(high.x, most.x), std::max(high.y, most.y), std::max(high.z, most.z)};
    max_radius = std::max(max_radius, largest);
  });
  origin = make_int4(low.x, low.y, low.z, 0);
  extent[0] = high.x - low.x;
  extent[1] = high.y - low.y;
  extent[2] = high.z - low.z;
  const int bits =
      std::bit_width(static_cast<std::uint32_t>(std::max({extent[0], extent[1], extent[2], 1})));
  scale = std::ldexp(1.0f, 12 - bits);
  weight = static_cast<float>(max_radius) * scale;
  weight *= weight * 1.00001f;
  small = std::max({extent[0], extent[1], extent[2]}) <= kMostSmall && max_radius <= kMostSmall / 2;

  arrived.reserve(n);
  balls.reserve(n);
  code.reserve(n);
  code_sorted.reserve(n);
  index.reserve(n);
  index_sorted.reserve(n);
  slot.reserve(n);
  stream.send(arrived, host_balls.get(), n);
  DeviceTimer timer(stream);
  const int per_axis = std::min(21, bits);
  stream.each(find_codes, n, arrived.get(), n, origin, bits - per_axis, code.get(), index.get());
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
  stream.each(gather_balls, n, arrived.get(), index_sorted.get(), n, balls.get(), slot.get());
  timer.stop();
  order_ms = timer.milliseconds();
}

// The tree of the balls that `needed` marks.
BallTree Wrapping::State::grow_tree() {
  place.reserve(n + 1);
  prefix_sum(needed.get(), place.get(), n + 1, scratch, stream);
  host_number.reserve(1);
  stream.fetch(host_number.get(), place.get() + n, 1);
  stream.wait("counting balls");
  const std::uint32_t count = *host_number.get();
  BallTree tree{};
  const std::uint32_t boxes = set_levels(tree, count);
  tree_balls.reserve(count);
  tree_slot.reserve(count);
  box_low.reserve(boxes);
  box_high.reserve(boxes);
  tree.ball = tree_balls.get();
  tree.slot = tree_slot.get();
  tree.boxes = {box_low.get(), box_high.get()};
  tree.origin = origin;
  tree.scale = scale;
  stream.each(gather_needed, n, balls.get(), needed.get(), place.get(), n, tree_balls.get(),
              tree_slot.get());
  stream.each(box_leaves, tree.count[0], tree);
  for (int level = 1; level <= tree.top; ++level)
    stream.each(box_level, tree.count[level], tree, level);
  return tree;
}

// A grid of the tree's balls. Its cells have this width (lattice units), or a larger one if there
// would be too many.
NearGrid Wrapping::State::make_grid(const BallTree& tree, double width) {
  GridMemory& memory = grid_memory;
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
  stream.fill(memory.start, 0, cells + 1);
  stream.each(count_cells, tree.balls, tree, grid);
  prefix_sum(memory.start.get(), memory.start.get(), cells + 1, scratch, stream);
  stream.each(fill_cells, tree.balls, tree, grid);
  return grid;
}

Wrapping::Wrapping() : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.stream.create();
  int device = 0;
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaDeviceGetAttribute(&s.multiprocessors, cudaDevAttrMultiProcessorCount, device),
        "asking for the device");
}

void Wrapping::load(const BallSet& balls) {
  State& s = *state_;
  s.load(balls);
  s.wrapped.stream = &s.stream;
  s.wrapped.balls = s.balls.get();
  s.wrapped.slots = s.n;
  s.wrapped.ball_of_slot = s.index_sorted.get();
  s.wrapped.scale = s.scale;
}

std::optional<DeviceBalls> Wrapping::shown_balls() {
  State& s = *state_;
  constexpr std::uint32_t kMostNear = 4096;
  s.shown.reserve(s.n);
  s.counts.reserve(1);
  s.host_number.reserve(1);
  s.stream.fill(s.counts, 0, 1);
  std::uint32_t* const too_many = &s.counts.get()->full;
  s.stream.each(find_shown, s.n, s.balls.get(), s.code_sorted.get(), s.index_sorted.get(), s.n,
                kMostNear, s.shown.get(), too_many);
  s.stream.fetch(s.host_number.get(), too_many, 1);
  s.stream.wait("looking for equal centres");
  if (*s.host_number.get() != 0) return std::nullopt;
  return DeviceBalls{s.shown.get(), s.n, s.low, s.high, s.max_radius, s.lattice};
}

double Wrapping::small_gap() {
  State& s = *state_;
  constexpr std::uint32_t kSamples = 2048;
  const std::uint32_t samples = std::min(kSamples, s.n);
  s.gaps.reserve(kSamples);
  s.stream.each(find_gaps, samples, s.balls.get(), s.n, samples, s.gaps.get());
  s.host_gaps.reserve(kSamples);
  float* const gaps = s.host_gaps.get();
  s.stream.fetch(gaps, s.gaps.get(), samples);
  s.stream.wait("measuring gaps");
  float* const decile = gaps + samples / 10;
  std::nth_element(gaps, decile, gaps + samples);
  return static_cast<double>(*decile);
}

Wrapping::~Wrapping() {
  cudaStreamSynchronize(state_->stream);
}

void Wrapping::State::reserve(const Rooms& rooms) {
  quads.reserve(rooms.quads);
  neighbours.reserve(4 * rooms.quads);
  apex.reserve(4 * rooms.quads);
  known_table.reserve(kBucket * rooms.known_buckets);
  table.reserve(kBucket * rooms.buckets);
  queue.reserve(rooms.queue);
  for (auto& list : lists) list.reserve(rooms.queue);
  candidates.reserve(rooms.queue);
  far_bounds.reserve(rooms.queue);
  bounds.reserve(rooms.queue);
  wide_nodes.reserve(std::size_t{2} * kWideNodes * static_cast<unsigned>(multiprocessors));
  counts.reserve(1);
  host_counts.reserve(1);
  needed.reserve(n + 1);
  found.reserve(n);
}

// Joins the known tetrahedra, queues their open faces, and marks the balls that a search may find.
Front Wrapping::State::find_open_faces(const BallIndex* known, const Rooms& rooms,
                                       WrappingResult& result) {
  const auto count = static_cast<std::uint32_t>(rooms.known);
  stream.fill(counts, 0, 1);
  stream.fill(neighbours, 0xff, 4 * rooms.quads);
  stream.fill(apex, 0xff, 4 * rooms.quads);
  stream.fill(known_table, 0xff, kBucket * rooms.known_buckets);
  stream.fill(table, 0xff, kBucket * rooms.buckets);
  stream.fill(needed, 0, n + 1);
  stream.fill(found, 0, n);
  const Front front{{quads.get(), neighbours.get()},
                    {table.get(), static_cast<std::uint32_t>(rooms.buckets)},
                    queue.get(),
                    apex.get(),
                    static_cast<std::uint32_t>(rooms.quads),
                    static_cast<std::uint32_t>(rooms.queue),
                    counts.get()};
  const FaceTable known_faces{known_table.get(), static_cast<std::uint32_t>(rooms.known_buckets)};
  DeviceTimer timer(stream);
  stream.each(read_quads, count, known, count, slot.get(), balls.get(), quads.get());
  stream.each(join_faces, 4 * rooms.known, front.faces, known_faces, count);
  stream.each(mark_found, count, quads.get(), count, found.get());
  stream.each(mark_hidden, n, front.faces, count, balls.get(), n, found.get(), kEarlyReach,
              kEarlySteps);
  stream.each(add_unfound, n, found.get(), n, needed.get());
  stream.each(queue_open_faces, 4 * rooms.known, front, count, needed.get());
  timer.stop();
  result.open_ms = timer.milliseconds();
  FrontCounts numbers = read_counts();
  result.open = numbers.tail;
  numbers.quads = numbers.quads_before = count;
  *host_counts.get() = numbers;
  stream.send(counts, host_counts.get(), 1);
  return front;
}

// Queues one round. With `times` it waits for the end, and measures each search.
void Wrapping::State::search_round(const Front& front, const SearchSpace& space,
                                   const NearGrid& grid, float guess,
                                   WrappingResult::Round* times) {
  const auto each_multiprocessor = static_cast<unsigned>(multiprocessors);
  const LaunchShape searching{kSearchBlocks * each_multiprocessor, kSearchThreads, stream};
  std::optional<DeviceTimer> timer;
  // Ends the step `of`, and begins the next.
  const auto next = [&](int of) {
    if (times == nullptr) return;
    timer->stop();
    times->milliseconds[static_cast<std::size_t>(of)] = timer->milliseconds();
    timer.emplace(stream);
  };
  launch(begin_round, {1, 32, stream}, counts.get());
  if (times != nullptr) timer.emplace(stream);
  launch(small ? search_near<true> : search_near<false>, searching, front, space, grid, guess,
         task(kNear).next, list(kFar), far_bounds.get());
  next(kNear);
  launch(small ? search_tree<false, true> : search_tree<false, false>, searching, front, space,
         task(kFar));
  next(kFar);
  launch(search_widely, {each_multiprocessor, kWideThreads, stream}, front, space, task(kWide),
         wide_nodes.get());
  next(kWide);
  launch(decide_faces, searching, front, balls.get(), list(kDoubtful), candidates.get());
  next(kDoubtful);
  launch(search_tree<true>, searching, front, space, task(kExact));
  next(kExact);
  launch(extend_front, {4 * searching.blocks, 256, stream}, front);
  next(kSearches);
  check(cudaGetLastError(), "starting a kernel");
  if (times == nullptr) return;
  const FrontCounts numbers = read_counts();
  std::copy_n(numbers.listed, +kSearches, times->faces.begin());
}

// Copies the tetrahedra after the known ones to the host.
void Wrapping::State::bring(std::size_t known, std::size_t all, WrappingResult& result) {
  host_index.reserve(n);
  const BallIndex* const ball_of_slot = host_index.get();
  stream.fetch(host_index.get(), index_sorted.get(), n);
  host_quads.reserve(all - known);
  stream.fetch(host_quads.get(), quads.get() + known, all - known);
  stream.wait("copying tetrahedra");
  result.found.resize(all - known);
  for (std::size_t t = 0; t < result.found.size(); ++t) {
    const Quad& q = host_quads.get()[t];
    auto& to = result.found[t];
    to = {ball_of_slot[q.x & ~kNegative], ball_of_slot[q.y], ball_of_slot[q.z], ball_of_slot[q.w]};
    std::sort(to.begin(), to.end());
  }
}

WrappingResult Wrapping::run(std::span<const std::array<BallIndex, 4>> known, double radius,
                             std::size_t room, bool bring, const CancelToken& cancel, bool timed) {
  State& s = *state_;
  s.vertices.reserve(4 * known.size());
  s.stream.send(s.vertices, known.data(), 4 * known.size());
  return run({s.vertices.get(), nullptr, known.size()}, radius, room, bring, cancel, timed);
}

WrappingResult Wrapping::run(const DeviceSimplices& known, double radius, std::size_t room,
                             bool bring, const CancelToken& cancel, bool timed) {
  State& s = *state_;
  WrappingResult result;
  result.known = known.count;
  result.order_ms = s.order_ms;
  const Rooms rooms(known.count, room);
  s.reserve(rooms);
  const Front front = s.find_open_faces(known.vertices, rooms, result);
  DeviceTimer growing(s.stream);
  const BallTree tree = s.grow_tree();
  const NearGrid grid = s.make_grid(tree, kCellsPerGuess * radius);
  growing.stop();
  result.needed = tree.balls;
  result.tree_ms = growing.milliseconds();

  const SearchSpace space{tree,          s.balls.get(),     s.place.get(),
                          s.weight,      s.list(kDoubtful), s.candidates.get(),
                          s.list(kWide), s.bounds.get(),    s.list(kExact)};
  const float guess = static_cast<float>(radius) * s.scale;
  DeviceTimer wrapping(s.stream);
  FrontCounts counts{};
  do {
    cancel.throw_if_cancelled();
    for (int round = 0; round < (timed ? 1 : kRoundsAtOnce); ++round) {
      if (timed) result.timed.emplace_back();
      s.search_round(front, space, grid, guess, timed ? &result.timed.back() : nullptr);
    }
    counts = s.read_counts();
  } while (counts.full == 0 && counts.end != counts.tail);
  wrapping.stop();
  result.front_ms = wrapping.milliseconds();
  result.rounds = counts.rounds;
  for (std::size_t search = 0; search < kSearches; ++search)
    result.searched[search] = counts.all[search] + counts.listed[search];
  result.hull = counts.hull;
  result.fits = counts.full == 0;
  s.wrapped.faces = front.faces;
  s.wrapped.count = counts.quads;
  s.wrapped.hull = counts.hull;
  s.wrapped.found = s.found.get();
  s.wrapped.spare = s.apex.get();
  if (bring && result.fits) s.bring(known.count, counts.quads, result);
  return result;
}

void Wrapping::mark_balls(std::uint32_t count) {
  const State& s = *state_;
  const Wrapped& all = s.wrapped;
  s.stream.each(keep_hidden, s.n, all.found, s.n);
  s.stream.each(mark_found, count, all.faces.quads, count, all.found);
  s.stream.each(mark_hidden, s.n, all.faces, count, all.balls, s.n, all.found, s.n, count);
}

const Wrapped& Wrapping::on_device() const {
  return state_->wrapped;
}

}  // namespace alphascope::gpu
