// SPDX-License-Identifier: GPL-3.0-or-later
// Puts sets of balls on the device: the plan of a run and its grid. The run itself is in
// dual_edge_run.cu.
#include "core/geometry/lattice_point.hpp"
#include "core/neighbours/coincident.hpp"
#include "gpu/dual_edge/grid_kernels.cuh"
#include "gpu/dual_edge/pipeline_state.cuh"

namespace alphascope::gpu {

DualEdgePipeline::DualEdgePipeline() : state_(std::make_unique<State>()) {
  State& s = *state_;
  int device = 0;
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaDeviceGetAttribute(&s.shared_limit, cudaDevAttrMaxSharedMemoryPerBlockOptin, device),
        "asking for its shared memory");
  check(cudaDeviceGetAttribute(&s.shared_per_multiprocessor,
                               cudaDevAttrMaxSharedMemoryPerMultiprocessor, device),
        "asking for its shared memory");
  check(cudaDeviceGetAttribute(&s.multiprocessors, cudaDevAttrMultiProcessorCount, device),
        "asking for its processors");
  s.queues.create();
  s.host_counters.reserve(1);
}

DualEdgePipeline::DualEdgePipeline(const BallSet& balls, int chunks) : DualEdgePipeline() {
  state_->chunks = chunks;
  load(balls);
}

void DualEdgePipeline::set_most_attempts(int attempts) {
  state_->most_attempts = attempts;
}

void DualEdgePipeline::State::expect(std::size_t count) {
  on_device.reset();
  tetrahedra_on_device = {};
  // What earlier balls needed is a guess, with a little more for the difference.
  const double ratio = n == 0 ? 1 : static_cast<double>(count) / static_cast<double>(n);
  const auto scaled = [&](std::size_t of) {
    return static_cast<std::size_t>(1.05 * ratio * static_cast<double>(of)) + 64;
  };
  for (Need& need : needs) {
    if (count != n) {
      for (std::size_t& own : need.counts.of) own = scaled(own);
      need.candidates = scaled(need.candidates);
    }
    need.totals.clear();
  }
  n = count;
}

void DualEdgePipeline::load(const BallSet& balls) {
  State& s = *state_;
  s.expect(balls.size());
  s.lattice = balls.lattice;
  s.packing.reset();
  s.source = nullptr;
  s.load(balls);
  s.reserve_balls();
}

void DualEdgePipeline::load(const DeviceBalls& balls) {
  State& s = *state_;
  s.expect(balls.count);
  s.lattice = balls.lattice;
  s.low = balls.low;
  s.high = balls.high;
  s.max_radius = balls.max_radius;
  s.packing.reset();
  s.source = static_cast<const int4*>(balls.balls);
  s.reserve_balls();
}

void DualEdgePipeline::State::reserve_balls() {
  balls.reserve(n);
  index.reserve(n);
  near.reserve(n);
  home.reserve(n);
  exact_list.reserve(n);
}

void Queues::create() {
  int least = 0, greatest = 0;
  check(cudaDeviceGetStreamPriorityRange(&least, &greatest), "asking for priorities");
  main.create(least);
  other.create(least);
  deciding.create(greatest);
  ordering.create(greatest);
  counting.create(greatest);
  copying.create(greatest);
  for (Event* e : {&assigned, &sorted, &faces_sent}) e->create(cudaEventDisableTiming);
  for (Event& e : arrived) e.create(cudaEventDisableTiming);
  for (auto* of_chunks : {&filtered, &decided, &faces_ordered, &ordered, &counted}) {
    for (Event& e : *of_chunks) e.create(cudaEventDisableTiming);
  }
}

cudaError_t Queues::wait(bool all) const {
  cudaError_t status = cudaStreamSynchronize(main);
  for (const Stream* s : {&other, &deciding, &ordering, &counting, &copying}) {
    if (!all) break;
    const cudaError_t own = cudaStreamSynchronize(*s);
    if (status == cudaSuccess) status = own;
  }
  return status;
}

void DualEdgePipeline::State::load(const BallSet& set) {
  low = high = n == 0 ? LatticePoint{} : set.centres[0];
  max_radius = n == 0 ? 1 : set.radii[0];
  for (BallIndex i = 0; i < n; ++i) {
    const LatticePoint& c = set.centres[i];
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    max_radius = std::max(max_radius, set.radii[i]);
  }
  const std::vector<bool> hidden = coincident_hidden(set);
  const ShownBalls shown{set, hidden};
  const BallPacker packer(shown);
  if (packer.pays()) {
    packing = packer.layout();
    host_packed.reserve(packing->words);
    packed.reserve(packing->words);
    packer.pack(host_packed.get());
    return;
  }
  host_balls.reserve(std::max<std::size_t>(n, 1));
  for (BallIndex i = 0; i < n; ++i) host_balls.get()[i] = shown[i];
}

DualEdgePipeline::~DualEdgePipeline() {
  state_->results->close();
}

void DualEdgePipeline::release_memory() {
  state_->results->release_memory();
  ResultMemory::free_unused();
}

std::optional<DeviceComplex> DualEdgePipeline::on_device() const {
  return state_->on_device;
}

DeviceSimplices DualEdgePipeline::tetrahedra_on_device() const {
  return state_->tetrahedra_on_device;
}

void DualEdgePipeline::State::keep_on_device(const ResultLayout& layout,
                                             const SimplexCounts& counts,
                                             const LatticeAlpha& alpha) {
  const auto list = [&](int d) {
    const ResultLayout::Section& at = layout.dimension[d];
    return DeviceSimplices{
        reinterpret_cast<const BallIndex*>(result.get() + at.vertices),
        d == 3 ? nullptr : reinterpret_cast<const SimplexClass*>(result.get() + at.simplex_class),
        counts[d]};
  };
  on_device = DeviceComplex{lattice, alpha,   reinterpret_cast<const std::int32_t*>(balls.get()),
                            n,       list(0), list(1),
                            list(2), list(3)};
}

std::optional<Problem> DualEdgePipeline::State::plan(const LatticeAlpha& alpha, bool whole) {
  State& s = *this;
  const double largest = alpha.plus(std::int64_t{s.max_radius} * s.max_radius);
  const double cutoff = 2 * std::sqrt(largest);
  if (!(cutoff < kMaxCutoff) || s.n > kMaxBalls) return std::nullopt;
  Problem p{};
  p.ball_count = static_cast<int>(s.n);
  p.alpha = alpha;
  p.whole = whole;
  p.scale = static_cast<float>(
      std::ldexp(1.0, -static_cast<int>(std::ceil(std::log2(std::max(cutoff, 2.0))))));
  p.ghost_reach = 4;
  while (static_cast<double>(p.ghost_reach) < std::sqrt(largest) + 2) p.ghost_reach *= 2;
  p.origin = make_int4(s.low.x, s.low.y, s.low.z, 0);
  // Coordinates up to 2^24 from the origin are exact in single precision. Beyond that, the
  // coordinates of both balls of a distance may be rounded.
  const double extent =
      std::max({static_cast<double>(s.high.x) - s.low.x, static_cast<double>(s.high.y) - s.low.y,
                static_cast<double>(s.high.z) - s.low.z});
  p.reach_slack = extent < 16777216.0 ? 0.0f : static_cast<float>(extent / 8388608.0);
  double width = std::ceil((cutoff + 2 * p.reach_slack) * (1 + 1e-4)) + 2;
  const auto cells = [&](std::int32_t from, std::int32_t to) {
    return std::floor((static_cast<double>(to) - from) / width) + 3;
  };
  while (cells(s.low.x, s.high.x) * cells(s.low.y, s.high.y) * cells(s.low.z, s.high.z) >
         8.0 * static_cast<double>(s.n) + 512) {
    width = std::ceil(width * 1.25);
  }
  p.cell_width = static_cast<int>(std::min(width, 2147483647.0));
  // Two parts of a cell are added, because BallCell::part is rounded down and sums of floats have
  // small errors.
  p.fraction = static_cast<float>(kCellParts / static_cast<double>(p.cell_width));
  p.reach_max = static_cast<float>((cutoff / 2 * (1 + 1e-4) + p.reach_slack) * p.fraction + 2);
  p.nx = static_cast<int>(cells(s.low.x, s.high.x));
  p.ny = static_cast<int>(cells(s.low.y, s.high.y));
  p.nz = static_cast<int>(cells(s.low.z, s.high.z));
  // One more cell is for dead balls.
  const std::size_t cell_count = static_cast<std::size_t>(p.nx) * p.ny * p.nz + 1;
  s.zeroed.reserve(kCounterWords + cell_count + 1 + kZeroedArrays * s.n);
  s.cell_start.reserve(cell_count + 1);
  p.cell_count = static_cast<int>(cell_count);
  return p;
}

int DualEdgePipeline::State::pieces() const {
  constexpr std::size_t kLarge = std::size_t{1} << 17;
  if (!packing) return 1;
  const std::size_t starts = (n + kWireStart - 1) / kWireStart;
  const bool several = chunks > 1 || n >= kLarge;
  return static_cast<int>(std::min<std::size_t>(several ? kMaxPieces : 1, starts));
}

// Pieces consist of whole starts of packed balls (ball_wire.cuh). The last piece is the smaller
// one, because nothing runs in parallel to its sorting.
std::size_t DualEdgePipeline::State::piece_begin(int piece, int all) const {
  static_assert(kMaxPieces == 2);
  const std::size_t starts = (n + kWireStart - 1) / kWireStart;
  return piece == 0 ? 0 : piece == all ? starts : starts - (starts + 3) / 4;
}

void DualEdgePipeline::State::send_piece(int piece, int all) {
  if (packing) {
    const std::uint32_t* words = host_packed.get();
    const auto word = [&](int k) -> std::size_t {
      return k == 0 ? 0 : k == all ? packing->words : words[packing->starts + piece_begin(k, all)];
    };
    check(cudaMemcpyAsync(packed.get() + word(piece), words + word(piece),
                          (word(piece + 1) - word(piece)) * 4, cudaMemcpyHostToDevice, queues.main),
          "copying the balls");
  } else {
    const bool there = source != nullptr;
    check(cudaMemcpyAsync(balls.get(), there ? source : host_balls.get(), n * sizeof(int4),
                          there ? cudaMemcpyDeviceToDevice : cudaMemcpyHostToDevice, queues.main),
          "copying the balls");
  }
}

void DualEdgePipeline::State::assign_piece(const Problem& p, int piece, int all,
                                           cudaStream_t stream) {
  const auto ball = [&](int k) {
    return static_cast<std::uint32_t>(std::min(n, piece_begin(k, all) * kWireStart));
  };
  const std::uint32_t begin = ball(piece), end = ball(piece + 1);
  launch(gpu::assign_cells, {blocks_for(end - begin), kThreads, stream}, p, begin, end,
         PackedBalls{packed.get(), packing.value_or(WireLayout{})},
         CellBuffers{balls.get(), zeroed.get() + kCounterWords, home.get()});
}

void DualEdgePipeline::State::receive_balls(const Problem& p, EventTimer& timer) {
  const int all = pieces(), last = all - 1;
  // With several pieces, the device puts one into cells while the next arrives.
  const cudaStream_t before_last = all > 1 ? queues.other : queues.main;
  // One fill clears the counters and the counts of cells and balls. Prefix sums also read, but do
  // not use, the number after the last.
  const std::size_t counts = p.whole ? kZeroedArrays * n : n + 1;
  check(cudaMemsetAsync(zeroed.get(), 0, (kCounterWords + p.cell_count + 1 + counts) * 4,
                        before_last),
        "clearing device memory");
  for (int piece = 0; piece < last; ++piece) {
    send_piece(piece, all);
    queues.arrived[piece].record(queues.main);
    queues.arrived[piece].make_wait(before_last);
    assign_piece(p, piece, all, before_last);
  }
  send_piece(last, all);
  timer.mark(stage::kHostToDevice, queues.main);
  if (all > 1) {
    queues.assigned.record(before_last);
    queues.assigned.make_wait(queues.main);
  }
  assign_piece(p, last, all, queues.main);
}

SortedBalls DualEdgePipeline::State::sort_into_cells(const Problem& p, EventTimer& timer) {
  receive_balls(p, timer);
  std::uint32_t* cell_count = zeroed.get() + kCounterWords;
  const LaunchShape per_ball{blocks_for(n), kThreads, queues.main};
  scan(cell_count, cell_start.get(), p.cell_count + 1, queues.main);
  launch(gpu::sort_into_cells, per_ball, p, balls.get(), cell_start.get(),
         SortedBuffers{index.get(), near.get(), home.get()});
  check(cudaGetLastError(), "sorting the balls");
  timer.mark(stage::kGrid, queues.main);
  return {index.get(), near.get(), cell_start.get(), home.get()};
}

}  // namespace alphascope::gpu
