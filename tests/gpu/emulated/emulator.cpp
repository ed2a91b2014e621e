// Grids on the CPU: see cuda_runtime.h.
#include <cuda_runtime.h>

#include <boost/context/fiber.hpp>
#include <boost/context/pooled_fixedsize_stack.hpp>
#include <deque>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

uint3 threadIdx, blockIdx, blockDim, gridDim;

namespace emulated {
namespace {

namespace context = boost::context;

// Where threads meet: the last one lets all go.
struct Barrier {
  unsigned expected = 0, arrived = 0, generation = 0;
};

struct Warp {
  Barrier barrier;
  std::uint64_t values[2][32];  // of this exchange and the one before
  unsigned turn[32];
};

class Block {
 public:
  void run(unsigned threads, const std::function<void()>& body) {
    if (threads % 32 != 0) throw std::logic_error("blocks of whole warps only");
    block_ = {threads, 0, 0};
    warps_.assign(threads / 32, {});
    for (Warp& w : warps_) w.barrier.expected = 32;
    fibers_.clear();
    fibers_.resize(threads);
    for (unsigned t = 0; t < threads; ++t) {
      fibers_[t] = context::fiber(std::allocator_arg, stacks_, [&](context::fiber&& main) {
        main_ = std::move(main);
        body();
        ++finished_;
        progress_ = true;
        return std::move(main_);
      });
    }
    finished_ = 0;
    while (finished_ < threads) {
      progress_ = false;
      for (unsigned t = 0; t < threads; ++t) {
        if (!fibers_[t]) continue;
        threadIdx = {t, 0, 0};
        fibers_[t] = std::move(fibers_[t]).resume();
      }
      if (!progress_) throw std::logic_error("threads of a block wait for each other in vain");
    }
  }

  void wait(Barrier& barrier) {
    const unsigned mine = barrier.generation;
    if (++barrier.arrived == barrier.expected) {
      barrier.arrived = 0;
      ++barrier.generation;
      progress_ = true;
      return;
    }
    while (barrier.generation == mine) {
      main_ = std::move(main_).resume();
    }
  }
  Barrier& block() { return block_; }
  Warp& warp() { return warps_[threadIdx.x / 32]; }

 private:
  context::pooled_fixedsize_stack stacks_{256 * 1024};
  std::vector<context::fiber> fibers_;
  context::fiber main_;  // what runs the fibers; theirs to resume
  unsigned finished_ = 0;
  bool progress_ = false;
  Barrier block_;
  std::vector<Warp> warps_;
};

Block the_block;
std::vector<std::uint64_t> memory;

}  // namespace

unsigned char* shared_memory() {
  return reinterpret_cast<unsigned char*>(memory.data());
}

void run_grid(unsigned blocks, unsigned threads, std::size_t shared_bytes,
              const std::function<void()>& body) {
  memory.assign(shared_bytes / 8 + 2, 0xa5a5a5a5a5a5a5a5u);
  gridDim = {blocks, 1, 1};
  blockDim = {threads, 1, 1};
  for (unsigned b = 0; b < blocks; ++b) {
    blockIdx = {b, 0, 0};
    the_block.run(threads, body);
  }
}

void wait_for_block() {
  the_block.wait(the_block.block());
}
void wait_for_warp() {
  the_block.wait(the_block.warp().barrier);
}
const std::uint64_t* exchange(std::uint64_t own) {
  Warp& w = the_block.warp();
  const int lane = emulated::lane();
  std::uint64_t* values = w.values[w.turn[lane]++ & 1];
  values[lane] = own;
  the_block.wait(w.barrier);
  return values;
}

}  // namespace emulated

// ---- streams -----------------------------------------------------------------------------------

// How often it was recorded, and how many of those recordings have been reached.
struct EmulatedEvent {
  unsigned recorded = 0, reached = 0;
};

struct EmulatedStream {
  struct Task {
    std::function<void()> work;
    EmulatedEvent* after;  // or null
    unsigned recording;    // of it
    bool is_ready() const { return after == nullptr || after->reached >= recording; }
  };
  std::deque<Task> tasks;
};

namespace emulated {
namespace {

std::vector<EmulatedStream*> streams;
bool newest_first = true;
std::minstd_rand order_of_runs;  // drawn anew whenever all is done

// Does one task. False when there is none that could be done.
bool step() {
  for (std::size_t n = 0; n < streams.size(); ++n) {
    auto& tasks = streams[newest_first ? streams.size() - 1 - n : n]->tasks;
    if (tasks.empty() || !tasks.front().is_ready()) continue;
    const std::function<void()> work = std::move(tasks.front().work);
    tasks.pop_front();
    if (work) work();
    return true;
  }
  return false;
}
bool is_idle() {
  return std::all_of(streams.begin(), streams.end(),
                     [](const EmulatedStream* s) { return s->tasks.empty(); });
}
template <class Done>
void step_until(const Done& done) {
  const bool was_idle = is_idle();
  while (!done()) {
    if (!step()) throw std::logic_error("streams wait for events that are never reached");
  }
  if (!was_idle && is_idle()) newest_first = (order_of_runs() >> 16 & 1) != 0;
}

}  // namespace

void finish_all() {
  step_until(is_idle);
}
void enqueue(EmulatedStream* stream, std::function<void()> work) {
  if (stream != nullptr) {
    stream->tasks.push_back({std::move(work), nullptr, 0});
    return;
  }
  finish_all();
  work();
}

}  // namespace emulated

cudaError_t cudaStreamCreateWithPriority(cudaStream_t* stream, unsigned, int) {
  *stream = new EmulatedStream;
  emulated::streams.push_back(*stream);
  return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  cudaStreamSynchronize(stream);
  std::erase(emulated::streams, stream);
  delete stream;
  return cudaSuccess;
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
  emulated::step_until([&] { return stream->tasks.empty(); });
  return cudaSuccess;
}
// Of its latest recording, as it is now.
cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned) {
  stream->tasks.push_back({nullptr, event, event->recorded});
  return cudaSuccess;
}
cudaError_t cudaEventCreate(cudaEvent_t* event) {
  *event = new EmulatedEvent;
  return cudaSuccess;
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
  const unsigned recording = ++event->recorded;
  emulated::enqueue(stream, [=] { event->reached = recording; });
  return cudaSuccess;
}
cudaError_t cudaEventSynchronize(cudaEvent_t event) {
  emulated::step_until([&] { return event->reached >= event->recorded; });
  return cudaSuccess;
}
cudaError_t cudaEventDestroy(cudaEvent_t event) {
  emulated::finish_all();
  delete event;
  return cudaSuccess;
}
