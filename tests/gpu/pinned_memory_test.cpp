// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pinned memory on the emulated device, which counts it: for results, and for registered
// pages of the program.
#include <gtest/gtest.h>

#include <cstring>

#include "gpu/gpu_engine.hpp"
#include "gpu/memory/page_locked.hpp"
#include "gpu/memory/result_memory.cuh"
#include "tests/gpu/emulated/device.h"
#include "tests/support/device_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

constexpr std::size_t kLittle = 4096, kMuch = 5 << 20;  // bytes

// A resting engine keeps no pinned memory but that of results in use. It is freed with these
// results, but not on their owner's thread.
TEST(PinnedMemory, IsGivenBackWhenTheEngineRests) {
  Random random(12);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 600, 8000, 500, 900));
  const AlphaRequest request{balls->lattice.square_angstrom(1e5), false};
  free_unused_gpu_memory();
  const std::size_t before = emulated::pinned_bytes();
  auto engine = testing::make_device_engine(balls);
  ASSERT_TRUE(engine);
  AlphaComplex shown = engine->compute(request, {});
  const std::uint64_t hash = shown.hash;
  engine->compute(request, {});  // freed at once, so it is idle
  const std::size_t at_work = emulated::pinned_bytes();
  engine->release_memory();
  const std::size_t resting = emulated::pinned_bytes();
  EXPECT_LT(resting, at_work);
  EXPECT_FALSE(is_gpu_memory_unused());
  shown = {};
  EXPECT_TRUE(is_gpu_memory_unused());
  EXPECT_EQ(emulated::pinned_bytes(), resting) << "freed by the thread that let go";
  free_unused_gpu_memory();
  EXPECT_FALSE(is_gpu_memory_unused());
  EXPECT_LT(emulated::pinned_bytes(), resting);

  shown = engine->compute(request, {});
  EXPECT_EQ(shown.hash, hash);
  engine.reset();
  shown = {};
  free_unused_gpu_memory();
  EXPECT_EQ(emulated::pinned_bytes(), before);
}

// The emulated device refuses every other registration of pages, as systems do that cannot.
TEST(PinnedMemory, OfMuchIsPagesOfOurOwnWhereTheyCanBeRegistered) {
  const std::size_t before = emulated::pinned_bytes(), own_before = emulated::registered_bytes();
  int own = 0;
  gpu::PageLocked memory;
  for (int time = 0; time < 4; ++time) {
    ASSERT_EQ(memory.allocate(kMuch + 1), cudaSuccess);
    std::memset(memory.get(), time, kMuch + 1);
    EXPECT_GT(emulated::pinned_bytes() - before, kMuch);
    const std::size_t registered = emulated::registered_bytes() - own_before;
    EXPECT_TRUE(registered == 0 || (registered > kMuch && registered % 4096 == 0)) << registered;
    own += registered > 0;
  }
  EXPECT_EQ(own, 2);
  ASSERT_EQ(memory.allocate(kLittle), cudaSuccess);
  EXPECT_EQ(emulated::registered_bytes(), own_before);
  EXPECT_EQ(emulated::pinned_bytes() - before, kLittle);
  memory.free();
  EXPECT_EQ(emulated::pinned_bytes(), before);
}

// The same with our own pages and with CUDA's. A result is taken, kept, freed and taken again.
TEST(PinnedMemory, OfLargeResultsIsTakenAgain) {
  gpu::ResultMemory::free_unused();
  const std::size_t before = emulated::pinned_bytes();
  for (int time = 0; time < 4; ++time) {
    const auto pool = std::make_shared<gpu::ResultMemory>();
    const unsigned char* first = nullptr;
    {
      const gpu::ResultMemory::Taken taken = pool->take(kMuch), other = pool->take(kMuch);
      EXPECT_TRUE(taken.grew && other.grew);
      std::memset(taken.memory.get(), 1, kMuch);
      std::memset(other.memory.get(), 2, kMuch);
      first = taken.memory.get();
      EXPECT_EQ(first[kMuch - 1], 1);
      EXPECT_GE(emulated::pinned_bytes() - before, 2 * kMuch);
    }
    const gpu::ResultMemory::Taken again = pool->take(kMuch - kLittle);
    EXPECT_FALSE(again.grew);
    pool->close();
  }
  gpu::ResultMemory::free_unused();
  EXPECT_EQ(emulated::pinned_bytes(), before);
}

// At rest, only one of two idle results stays if they are large. A third result exists only during
// a drag; it would take as much memory as everything else.
TEST(PinnedMemory, OfTwoIdleResultsOnlyOneIsKeptWhereTheyAreLarge) {
  constexpr std::size_t kLarge = std::size_t{140} << 20;
  for (const std::size_t bytes : {kMuch, kLarge}) {
    gpu::ResultMemory::free_unused();
    const std::size_t before = emulated::pinned_bytes();
    const auto pool = std::make_shared<gpu::ResultMemory>();
    { const gpu::ResultMemory::Taken one = pool->take(bytes), other = pool->take(bytes); }
    EXPECT_EQ(gpu::ResultMemory::is_any_unused(), bytes == kLarge);
    gpu::ResultMemory::free_unused();
    const std::size_t kept = emulated::pinned_bytes() - before;
    EXPECT_GE(kept, bytes == kLarge ? bytes : 2 * bytes);
    EXPECT_LT(kept, bytes == kLarge ? 2 * bytes : 3 * bytes);
    EXPECT_FALSE(pool->take(bytes).grew);
    pool->close();
  }
  gpu::ResultMemory::free_unused();
}

}  // namespace
}  // namespace alphascope
