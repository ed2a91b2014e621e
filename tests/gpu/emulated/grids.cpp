// SPDX-License-Identifier: GPL-3.0-or-later
// Runs grids of the emulated device on the CPU, every thread of a block as a fiber. See
// cuda_runtime.h.
#include "tests/gpu/emulated/grids.h"

#include <cuda_runtime.h>

#include <boost/context/fiber.hpp>
#include <boost/context/pooled_fixedsize_stack.hpp>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

uint3 threadIdx, blockIdx, blockDim, gridDim;

namespace emulated {
namespace {

namespace context = boost::context;

// A meeting point of threads. The last one to arrive releases all.
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
        try {
          body();
        } catch (const std::exception&) {
          failure_ = std::current_exception();
        }
        ++finished_;
        progress_ = true;
        return std::move(main_);
      });
    }
    finished_ = 0;
    while (finished_ < threads) {
      if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
      progress_ = false;
      for (unsigned t = 0; t < threads; ++t) {
        if (!fibers_[t]) continue;
        threadIdx = {t, 0, 0};
        fibers_[t] = std::move(fibers_[t]).resume();
      }
      if (!progress_) throw std::logic_error("threads of a block wait for each other in vain");
    }
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
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
  context::fiber main_;  // runs the fibers, and is resumed by them
  unsigned finished_ = 0;
  bool progress_ = false;
  std::exception_ptr failure_;
  Barrier block_;
  std::vector<Warp> warps_;
};

Block the_block;
std::vector<std::uint64_t> memory;

}  // namespace

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

unsigned char* shared_memory() {
  return reinterpret_cast<unsigned char*>(memory.data());
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
