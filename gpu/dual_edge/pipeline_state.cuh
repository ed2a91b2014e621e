// SPDX-License-Identifier: GPL-3.0-or-later
// Data shared by the runs for one set of balls: device buffers, the plan of the grid, event timing.
// Only the pipeline's sources include it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/geometry/lattice_point.hpp"
#include "gpu/dual_edge/ball_wire.cuh"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/dual_edge/problem.cuh"
#include "gpu/memory/device_buffer.cuh"
#include "gpu/memory/handles.cuh"
#include "gpu/memory/launch.cuh"
#include "gpu/memory/prefix_sum.cuh"
#include "gpu/memory/result_memory.cuh"

namespace alphascope::gpu {

inline constexpr int kThreads = 256;

inline unsigned blocks_for(std::size_t items) {
  return static_cast<unsigned>((items + kThreads - 1) / kThreads);
}

// Below 2^24 by the margins that the neighbour search may add. So differences of neighbours stay
// exact in single precision and within the double brackets.
inline constexpr double kMaxCutoff = 16.7e6;

inline constexpr int kMaxList = 4095;  // 12 bits of a packed triangle
static_assert(kMaxBalls < std::size_t{1} << 30, "two bits of a slot are marks");

// The counters of one run, together so that one copy brings them back.
struct Counters {
  std::uint64_t hash[4];  // HashSums::sum
  BlockStatistics blocks;
  std::uint32_t edges, triangles, tetrahedra;  // numbers found; edges: candidates
  std::uint32_t pending;                       // as PendingTriangles::count
  std::uint32_t missing_edges;                 // as EdgeCandidates::missing
  std::uint32_t exact_count[kMaxChunks];       // numbers of balls for kernel III
  Totals totals[kMaxChunks + 1];               // numbers of simplices before each chunk, and of all
};

inline constexpr std::size_t kCounterWords = sizeof(Counters) / 4;

// Numbers of simplices by dimension.
struct SimplexCounts {
  std::size_t of[4] = {0, 0, 0, 0};
  std::size_t& operator[](int dimension) { return of[dimension]; }
  std::size_t operator[](int dimension) const { return of[dimension]; }
  bool cover(const SimplexCounts& other) const {
    for (int d = 0; d < 4; ++d) {
      if (of[d] < other.of[d]) return false;
    }
    return true;
  }
};

// Offsets of a result's arrays in one piece of memory. They are equal on device and host, so one
// copy brings all. Tetrahedra of K_alpha are interior, so the device writes no classes for them.
// Only the host has room for these, at the end.
struct ResultLayout {
  struct Section {
    std::size_t vertices, value, simplex_class;  // bytes from the start
  };
  Section dimension[4];
  SimplexCounts room;
  std::size_t bytes = 0, host_bytes = 0;

  ResultLayout(const SimplexCounts& counts, bool whole) : room(counts) {
    const auto take = [&](std::size_t size) {
      const std::size_t at = bytes;
      bytes += (size + 255) / 256 * 256;
      return at;
    };
    for (int d = 0; d < 4; ++d) {
      const std::size_t count = whole || d == 3 ? counts[d] : 0;
      dimension[d].vertices = take(count * 4 * (d + 1));
      dimension[d].value = take(whole ? count * 4 : 0);
      if (d < 3) dimension[d].simplex_class = take(whole ? count : 0);
    }
    dimension[3].simplex_class = bytes;
    host_bytes = bytes + (whole ? counts[3] : 0);
  }
};

class EventTimer {
 public:
  EventTimer(cudaStream_t stream, StageTimes* times) : stream_(stream), times_(times) {
    if (times_ == nullptr) return;
    for (Event& e : events_) e.create(cudaEventDefault);
    events_[0].record(stream_);
  }
  // Ends a stage. Its time is what it takes beyond the end of the previous stage.
  void mark(std::string_view label, cudaStream_t stream) {
    if (times_ == nullptr) return;
    labels_.push_back(label);
    events_[labels_.size()].record(stream);
  }
  // Must be called after the stream has finished.
  void report() {
    if (times_ == nullptr) return;
    constexpr double kWorthSaying = 0.1;
    if (before_ > kWorthSaying)
      times_->stages.push_back({std::string(stage::kMakingRoom), before_, false});
    float end = 0;
    for (std::size_t s = 0; s < labels_.size(); ++s) {
      float at = 0;
      check(cudaEventElapsedTime(&at, events_[0], events_[s + 1]), "reading an event");
      const float beyond = std::max(at - end, 0.0f);
      end += beyond;
      if (beyond > 0 || labels_[s] != stage::kMakingRoom)
        times_->stages.push_back({std::string(labels_[s]), beyond, false});
    }
  }
  // Starts the clock of the stages. The time before is reported as making room.
  void restart() {
    labels_.clear();
    if (times_ == nullptr) return;
    before_ = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    events_[0].record(stream_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  cudaStream_t stream_;
  StageTimes* times_;
  const Clock::time_point start_ = Clock::now();
  double before_ = 0;  // milliseconds
  Event events_[16];
  std::vector<std::string_view> labels_;
};

// The number of pieces in which large sets of balls arrive.
inline constexpr int kMaxPieces = 2;

// The queues of a run. Unless stated otherwise, those after the first and the events are only for
// runs in several chunks.
struct Queues {
  Stream main;   // balls to the device, the grid, kernel II of every other chunk
  Stream other;  // kernel II of the chunks between; before that, pieces of balls
  // Kernel III and the ordering of simplices; both have priority over kernel II.
  Stream deciding, ordering;
  Stream counting;  // copies of counts
  Stream copying;   // simplices to the host; for a run in one chunk, triangles and tetrahedra
  Event arrived[kMaxPieces], assigned, sorted, faces_sent;
  Event filtered[kMaxChunks], decided[kMaxChunks], faces_ordered[kMaxChunks], ordered[kMaxChunks],
      counted[kMaxChunks];

  void create();
  // The queue for kernel II of a chunk.
  cudaStream_t filtering(int chunk) const { return chunk % 2 == 0 ? main : other; }
  // Waits until all queued work is done, in `main` or in all queues.
  cudaError_t wait(bool all) const;
};

// The buffers of one set of balls, kept from run to run, and the needs of earlier runs.
struct DualEdgePipeline::State {
  Queues queues;
  Lattice lattice;
  std::size_t n = 0;
  int most_attempts = kMostAttempts;
  int chunks = 0;  // as given to DualEdgePipeline's constructor
  LatticePoint low, high;
  std::int32_t max_radius = 0;
  // The room that a run needed, by alpha.
  struct Need {
    LatticeAlpha alpha;
    bool whole;
    int balls_per_block;
    BlockRoom block, ball;       // of kernel II's blocks, and of kernel III's, which take one ball
    BlockRoom longest;           // room that kernel III would have needed, where it is known
    SimplexCounts counts;        // of the result
    std::size_t candidates;      // number of edge candidates
    bool cull;                   // KernelKind::kCull of kernel II
    double margin;               // as in room_for()
    bool counted;                // whether a run of exactly this alpha counted
    std::vector<Totals> totals;  // if so, the totals after each of its chunks
  };
  std::vector<Need> needs;
  // Properties of the device: shared memory of a block and of a multiprocessor, bytes; number of
  // these.
  int shared_limit = 0, shared_per_multiprocessor = 0, multiprocessors = 1;

  // The balls as they are sent: packed if that is smaller, else unpacked.
  PinnedBuffer<int4> host_balls;
  const int4* source = nullptr;  // balls in device memory that are taken instead
  PinnedBuffer<std::uint32_t> host_packed;
  DeviceBuffer<std::uint32_t> packed;
  std::optional<WireLayout> packing;
  PinnedBuffer<Counters> host_counters;
  DeviceBuffer<int4> balls;
  // Memory cleared at once at the start of a run. It holds the Counters, the counts of cells, and
  // six arrays for balls. These are numbers of tetrahedra, triangles and edge candidates, and data
  // of vertices (VertexStates).
  DeviceBuffer<std::uint32_t> zeroed;
  DeviceBuffer<std::uint32_t> index, cell_start, exact_list;
  DeviceBuffer<float4> near;
  DeviceBuffer<BallCell> home;
  DeviceBuffer<unsigned char> scratch;
  // Output of the blocks (dual_edge_block.cuh).
  struct {
    DeviceBuffer<uint4> vertices;
    DeviceBuffer<std::uint32_t> start;
  } tetrahedra;
  struct {
    DeviceBuffer<std::uint32_t> vertices, info, attached_to, start;
  } triangles;
  struct {
    DeviceBuffer<std::uint32_t> end, least, flags, start;
  } edges;
  DeviceBuffer<std::uint32_t> offset, pending, edges_found;
  DeviceBuffer<std::uint64_t> places;
  DeviceBuffer<unsigned char> result;
  // The result of the last run, if it was of the whole complex and was completed.
  std::optional<DeviceComplex> on_device;
  DeviceSimplices tetrahedra_on_device;
  std::shared_ptr<ResultMemory> results = std::make_shared<ResultMemory>();

  Counters* counters() { return reinterpret_cast<Counters*>(zeroed.get()); }

  // The grid for this alpha; its buffers are reserved. Empty if differences would not be exact.
  std::optional<Problem> plan(const LatticeAlpha& alpha, bool whole);
  SortedBalls sort_into_cells(const Problem& p, EventTimer& timer);
  void load(const BallSet& balls);
  // Takes so many balls, which are not there yet.
  void expect(std::size_t count);
  void reserve_balls();
  // Receive balls in one piece or several, and put them into their cells.
  int pieces() const;
  std::size_t piece_begin(int piece, int all) const;  // in units of kWireStart balls
  void send_piece(int piece, int all);
  void assign_piece(const Problem& p, int piece, int all, cudaStream_t stream);
  void receive_balls(const Problem& p, EventTimer& timer);
  // Number of arrays of n words in `zeroed`, after the counters and the cells.
  static constexpr int kZeroedArrays = 6;
  std::uint32_t* zeroed_array(const Problem& p, int number) {
    return zeroed.get() + kCounterWords + p.cell_count + 1 + static_cast<std::size_t>(number) * n;
  }

  // Sets for each number the sum of the numbers before it.
  template <class Numbers, class Number>
  void scan(Numbers in, Number* out, std::size_t count, cudaStream_t stream) {
    prefix_sum(in, out, count, scratch, stream);
  }
  void keep_on_device(const ResultLayout& layout, const SimplexCounts& counts,
                      const LatticeAlpha& alpha);
  void fill(void* data, int byte, std::size_t bytes) {
    check(cudaMemsetAsync(data, byte, bytes, queues.main), "clearing device memory");
  }
};

}  // namespace alphascope::gpu
