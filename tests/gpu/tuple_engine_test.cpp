// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the tuple engine on the GPU equals the CPU's dual-edge engine byte for byte, with any
// switches. Also tests messages without a device.
#include "gpu/tuples/tuple_engine.hpp"

#include <gtest/gtest.h>

#include "core/geometry/alpha.hpp"
#include "core/run/cancel_token.hpp"
#include "core/tuples/tuple_engine.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/gpu/how_much.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::expect_same;
using testing::NamedBalls;
using testing::Random;

// Returns settings with one switch changed each, and one with all of them changed.
std::vector<TupleOptions> some_switches() {
  std::vector<TupleOptions> all(8);
  all[1].grid = TupleGridKind::thesis;
  all[2].edge_optimisation = false;
  all[3].alpha_optimisation = false;
  all[4].pinned = false;
  all[5].streams = 1;
  all[6].texture = false;
  all[7] = {TupleGridKind::thesis, false, false, false, 3, false, 5000};
  return all;
}

TEST(GpuTuples, EqualTheCpuOnHardSetsWhateverTheSwitches) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(41);
  for (const NamedBalls& set : testing::large_hard_sets(random, testing::kLargeForTuples)) {
    SCOPED_TRACE(set.name);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double unit = set.alpha_unit();
    for (const TupleOptions& options : some_switches()) {
      std::string why_not;
      const auto gpu = make_gpu_tuple_engine(balls, options, &why_not);
      ASSERT_TRUE(gpu) << why_not;
      const auto cpu = make_cpu_engine(balls);
      const auto tuples = make_tuple_engine(balls, {}, options);
      for (const double alpha : testing::kSomeAlphas) {
        for (const bool only : {true, false}) {
          const AlphaRequest request{alpha * unit, only};
          const AlphaComplex found = gpu->compute(request, {});
          expect_same(found, cpu->compute(request, {}));
          // The arithmetic is the same, so even the band equals the CPU's.
          const AlphaComplex on_cpu = tuples->compute(request, {});
          for (std::size_t c = 0; c + 1 < found.engine.counters.size(); ++c) {
            EXPECT_EQ(found.engine.counters[c].value, on_cpu.engine.counters[c].value)
                << found.engine.counters[c].name;
          }
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

// Small batches take turns on the streams, in buffers that are reused and grow.
TEST(GpuTuples, EqualTheCpuInManyBatches) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(43);
  for (const NamedBalls& set : testing::large_hard_sets(random, 12)) {
    SCOPED_TRACE(set.name);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double unit = set.alpha_unit();
    const auto cpu = make_cpu_engine(balls);
    for (const int streams : {1, 2, 5}) {
      for (const bool pinned : {true, false}) {
        TupleOptions options;
        options.streams = streams;
        options.pinned = pinned;
        options.texture = pinned == (streams > 1);
        options.edge_optimisation = false;
        options.tuples_per_batch = 40;
        const auto gpu = make_gpu_tuple_engine(balls, options, nullptr);
        ASSERT_TRUE(gpu);
        for (const double alpha : {-2.0, 3.0, 0.5, 40.0}) {
          const AlphaRequest request{alpha * unit};
          expect_same(gpu->compute(request, {}), cpu->compute(request, {}));
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

// Balls are so far apart that floats decide nothing, so every tuple goes to kernel III. There are
// more tuples than threads for them on a device of two multiprocessors, such as the emulated one.
TEST(GpuTuples, EqualTheCpuWhereIntegersDecideAll) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(44);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 22, 1 << 28, 1, 1 << 24));
  const auto engine = make_gpu_tuple_engine(balls, {}, nullptr);
  ASSERT_TRUE(engine);
  const AlphaComplex found = engine->compute({1e30}, {});
  expect_same(found, make_cpu_engine(balls)->compute({1e30}, {}));
  const EngineCounter& undecided = found.engine.counters.at(5);
  EXPECT_EQ(undecided.name, "4-tuples into kernel III");
  EXPECT_GT(undecided.value, 5000u);
}

TEST(GpuTuples, StayUsableWhenCancelled) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(42);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 3000, 20000, 500, 1500));
  const auto engine = make_gpu_tuple_engine(balls, {}, nullptr);
  ASSERT_TRUE(engine);
  RunContext context;
  context.progress = [&](std::string_view, double) { context.cancel.cancel(); };
  EXPECT_THROW(engine->compute({1e5}, context), Cancelled);
  expect_same(engine->compute({1e5}, {}), make_cpu_engine(balls)->compute({1e5}, {}));
}

TEST(GpuTuples, SayWhyTheyCannotBeUsed) {
  if (gpu_device().usable) GTEST_SKIP() << gpu_device().name << " is usable";
  BallSet balls;
  balls.centres.push_back({0, 0, 0});
  balls.radii.push_back(1000);
  std::string why_not;
  EXPECT_EQ(make_gpu_tuple_engine(std::make_shared<const BallSet>(balls), {}, &why_not), nullptr);
  EXPECT_EQ(why_not, gpu_device().why_not);
  EXPECT_FALSE(why_not.empty());
}

}  // namespace
}  // namespace alphascope
