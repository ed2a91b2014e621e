// What the runs for one set of balls share: device buffers, the plan of the grid, event timing.
// Included by the pipeline's sources only.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

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

// Below 2^24, by what the margins of the neighbour search may add: differences of neighbours stay
// exact in single precision and within the double brackets.
inline constexpr double kMaxCutoff = 16.7e6;

inline constexpr int kMaxList = 4095;  // 12 bits of a packed triangle
static_assert(kMaxBalls < std::size_t{1} << 30, "two bits of a slot are marks");

// Counters of one run, together so that one copy brings them back.
struct Counters {
  std::uint64_t hash[4];  // HashSums::sum
  BlockStatistics blocks;
  std::uint32_t edges, triangles, tetrahedra;  // found; edges: candidates
  std::uint32_t pending;                       // PendingTriangles
  std::uint32_t missing_edges;                 // EdgeCandidates::missing
  std::uint32_t exact_count[kMaxChunks];       // balls for kernel III
  Totals totals[kMaxChunks + 1];               // before each chunk, and of all
};

inline constexpr std::size_t kCounterWords = sizeof(Counters) / 4;

// How many simplices there are of each dimension.
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

// Where the arrays of a result lie in one piece of memory, the same on the device and on the host,
// so that one copy brings all. Tetrahedra of K_alpha are interior: the device needn't say so, and
// only the host has room for that, at the end.
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
  // What a stage takes beyond the end of the one before.
  void mark(std::string_view label, cudaStream_t stream) {
    if (times_ == nullptr) return;
    labels_.push_back(label);
    events_[labels_.size()].record(stream);
  }
  // After the stream has finished.
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
  // What was before made room.
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

// In which large sets of balls arrive.
inline constexpr int kMaxPieces = 2;

// Where the work of a run is queued. Those after the first, and the events, are for runs in several
// chunks, but where it says so.
struct Queues {
  Stream main;   // balls in, the grid, kernel II of every other chunk
  Stream other;  // kernel II of the chunks between; before, pieces that arrived
  // Kernel III and the order of simplices, which go before what is left of kernel II.
  Stream deciding, ordering;
  Stream counting;  // how many simplices there are
  Stream copying;   // the simplices out; of a run in one chunk, triangles and tetrahedra
  Event arrived[kMaxPieces], assigned, sorted, faces_sent;
  Event filtered[kMaxChunks], decided[kMaxChunks], faces_ordered[kMaxChunks], ordered[kMaxChunks],
      counted[kMaxChunks];

  void create();
  // Kernel II of a chunk.
  cudaStream_t filtering(int chunk) const { return chunk % 2 == 0 ? main : other; }
  cudaError_t wait(bool all) const;  // until what is queued is done: in `main`, or in all
};

// The buffers of one set of balls, kept from run to run, and what earlier runs needed.
struct DualEdgePipeline::State {
  Queues queues;
  Lattice lattice;
  std::size_t n = 0;
  int chunks = 0;  // as DualEdgePipeline's constructor was told
  LatticePoint low, high;
  std::int32_t max_radius = 0;
  // What earlier runs needed, by alpha.
  struct Need {
    LatticeAlpha alpha;
    bool whole;
    int balls_per_block;
    BlockRoom block, ball;       // of kernel II's blocks, and of kernel III's, which take one ball
    BlockRoom longest;           // what kernel III would have needed room for, where it is known
    SimplexCounts counts;        // of the result
    std::size_t candidates;      // edges
    bool cull;                   // KernelKind::kCull of kernel II
    double margin;               // of room_for()
    bool counted;                // by a run of this very alpha
    std::vector<Totals> totals;  // then, after each of its chunks
  };
  std::vector<Need> needs;
  // Of the device: shared memory of a block and of a multiprocessor, bytes.
  int shared_limit = 0, shared_per_multiprocessor = 0, multiprocessors = 1;

  // The balls as they are sent: packed where that is smaller, else as they are.
  PinnedBuffer<int4> host_balls;
  PinnedBuffer<std::uint32_t> host_packed;
  DeviceBuffer<std::uint32_t> packed;
  std::optional<WireLayout> packing;
  PinnedBuffer<Counters> host_counters;
  DeviceBuffer<int4> balls;
  // Cleared at once at the start of a run: Counters, then the cells' counts, the balls' of
  // tetrahedra, triangles and edge candidates, and what is known of vertices (VertexStates).
  DeviceBuffer<std::uint32_t> zeroed;
  DeviceBuffer<std::uint32_t> index, cell_start, exact_list;
  DeviceBuffer<float4> near;
  DeviceBuffer<BallHome> home;
  DeviceBuffer<unsigned char> scratch;
  // As blocks write them (dual_edge_block.cuh).
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
  // Of the last run, and of which alpha, when it was of the whole complex and came to its end.
  std::optional<DeviceComplex> on_device;
  std::shared_ptr<ResultMemory> results = std::make_shared<ResultMemory>();

  Counters* counters() { return reinterpret_cast<Counters*>(zeroed.get()); }

  // The grid for this alpha, with its buffers; nothing when differences would not be exact.
  std::optional<Problem> plan(const LatticeAlpha& alpha, bool whole);
  SortedBalls sort_into_cells(const Problem& p, EventTimer& timer);
  void load(const BallSet& balls);
  // Balls come in one piece or several, and are put into their cells.
  int pieces() const;
  std::size_t piece_begin(int piece, int all) const;  // in kWireStart balls
  void send_piece(int piece, int all);
  void assign_piece(const Problem& p, int piece, int all, cudaStream_t stream);
  void receive_balls(const Problem& p, EventTimer& timer);
  // Words of `zeroed` that come after the counters and the cells: arrays of n.
  static constexpr int kZeroedArrays = 6;
  std::uint32_t* zeroed_array(const Problem& p, int number) {
    return zeroed.get() + kCounterWords + p.cell_count + 1 + static_cast<std::size_t>(number) * n;
  }

  // Sums of the numbers before each.
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
