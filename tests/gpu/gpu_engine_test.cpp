// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the CUDA engine equals the CPU's byte for byte on a machine with a device. Also tests
// messages where there is none.
#include "gpu/gpu_engine.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "core/measure/engine_measures.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "tests/gpu/how_much.hpp"
#include "tests/support/device_engine.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::expect_same;
using testing::NamedBalls;
using testing::Random;

void expect_same_on_gpu(const std::shared_ptr<const BallSet>& balls, double alpha_angstrom2) {
  std::string why_not;
  const auto gpu = testing::make_device_engine(balls, &why_not);
  ASSERT_TRUE(gpu) << why_not;
  const auto cpu = make_cpu_engine(balls);
  for (const bool tetrahedra_only : {true, false}) {
    const AlphaComplex found = gpu->compute({alpha_angstrom2, tetrahedra_only}, {});
    const AlphaComplex expected = cpu->compute({alpha_angstrom2, tetrahedra_only}, {});
    SCOPED_TRACE("alpha " + std::to_string(alpha_angstrom2) + ", " + found.engine.route);
    expect_same(found, expected);
  }
}

TEST(Gpu, EqualsTheCpuOnHardSets) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(5);
  for (const NamedBalls& set : testing::large_hard_sets(random, testing::kLarge)) {
    SCOPED_TRACE(set.name);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double unit = set.alpha_unit();
    for (const double alpha : testing::kSomeAlphas) expect_same_on_gpu(balls, alpha * unit);
  }
}

// As the solvent radius moves, and then for quite other balls.
TEST(Gpu, TakesOtherBalls) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(15);
  std::vector<std::pair<std::shared_ptr<const BallSet>, double>> sets;
  const BallSet some = testing::random_balls(random, 150, 1000, 100, 300);
  for (const double solvent : {0.0, 1.0, 20.0, 1.0})
    sets.push_back({std::make_shared<const BallSet>(with_solvent(some, solvent)), 0.05});
  for (const NamedBalls& set : testing::large_hard_sets(random, testing::kLarge))
    sets.push_back({std::make_shared<const BallSet>(set.balls), set.alpha_unit()});
  std::unique_ptr<Engine> gpu;
  int taken = 0;
  for (const auto& [balls, unit] : sets) {
    if (gpu && gpu->take(balls)) {
      ++taken;
    } else {  // the CPU answered for the device
      gpu = testing::make_device_engine(balls);
    }
    const auto cpu = make_cpu_engine(balls);
    for (const AlphaRequest& request : {AlphaRequest{unit, false}, AlphaRequest{0.0, true},
                                        AlphaRequest{2 * unit, false}, AlphaRequest{unit, false}}) {
      const AlphaComplex found = gpu->compute(request, {});
      expect_same(found, cpu->compute(request, {}));
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(taken, 5);
}

// A complex that is still on the device is measured there. Any other complex of its balls is sent
// to it.
TEST(GpuEngineMeasures, AreOfTheComplexAskedFor) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(14);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 150, 1000, 100, 300));
  const auto engine = testing::make_device_engine(balls), cpu = make_cpu_engine(balls);
  ASSERT_TRUE(engine);
  WorkThreads threads(1);
  const auto expect_those = [&](const AlphaComplex& complex, const std::string& route) {
    const UnionMeasures expected = measure_union(*balls, complex, {1});
    const auto found = measure_on_device(*engine, *balls, complex, threads, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->device, gpu_device().name);
    EXPECT_EQ(found->route, route);
    EXPECT_NEAR(found->measures.area_angstrom2(), expected.area_angstrom2(),
                1e-12 * expected.area_angstrom2());
    EXPECT_NEAR(found->measures.volume_angstrom3(), expected.volume_angstrom3(),
                1e-12 * expected.volume_angstrom3());
  };
  const std::string there = "the complex was still on the device",
                    sent = "the complex was sent to the device";
  expect_those(cpu->compute({0.02}, {}), sent);  // before its first answer
  const AlphaComplex small = engine->compute({0.02}, {});
  expect_those(small, there);
  const AlphaComplex large = engine->compute({0.1}, {});
  expect_those(large, there);
  expect_those(small, sent);
  expect_those(large, there);
  engine->release_memory();
  expect_those(large, there);
  engine->compute({0.1, true}, {});
  expect_those(large, sent);
  EXPECT_THROW(measure_on_device(*engine, *balls, engine->compute({0.1, true}, {}), threads, {}),
               std::invalid_argument);
}

// A run in several chunks passes results to edges and vertices of later chunks. From the third run
// of an alpha on it knows how much each chunk will find.
class GpuChunks : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  }
};
INSTANTIATE_TEST_SUITE_P(Numbers, GpuChunks, ::testing::ValuesIn(testing::kNumbersOfChunks));

TEST_P(GpuChunks, EqualTheCpuRunAfterRun) {
  Random random(7);
  for (const NamedBalls& set : testing::large_hard_sets(random, testing::kLarge)) {
    SCOPED_TRACE(set.name);
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double unit = set.alpha_unit();
    const auto gpu = testing::make_device_engine(balls, nullptr, {GetParam()}),
               cpu = make_cpu_engine(balls);
    ASSERT_TRUE(gpu);
    for (const double alpha : {0.25, 3.0, 0.25, 0.25}) {
      for (const bool tetrahedra_only : {true, false}) {
        SCOPED_TRACE("alpha " + std::to_string(alpha * unit));
        const AlphaRequest request{alpha * unit, tetrahedra_only};
        const AlphaComplex found = gpu->compute(request, {}), expected = cpu->compute(request, {});
        expect_same(found, expected);
        EXPECT_EQ(found.hash, expected.hash);
      }
    }
  }
}

// Large sets are sent in pieces of some thousand balls.
TEST(GpuPieces, EqualTheCpu) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  std::mt19937 random(8);
  std::uniform_int_distribution<int> at(0, 40000), radius(900, 1500);
  BallSet set;
  for (int b = 0; b < 13000; ++b) {
    set.centres.push_back({at(random), at(random), at(random)});
    set.radii.push_back(radius(random));
  }
  const auto balls = std::make_shared<const BallSet>(set);
  const AlphaRequest request{0, false};
  const AlphaComplex expected = make_cpu_engine(balls)->compute(request, {});
  EXPECT_GT(expected.tetrahedra.size(), 50u);
  for (int run = 0; run < testing::unless_sanitized(6, 2);
       ++run) {  // the first run counts; later ones send the same
    const auto gpu = testing::make_device_engine(balls, nullptr, {3});
    ASSERT_TRUE(gpu);
    expect_same(gpu->compute(request, {}), expected);
  }
}

// A slider that moves up gives one new alpha after another, each slightly larger than the last.
TEST(Gpu, RunsOnceWhenAlphaRisesALittle) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(9);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 2000, 12000, 500, 900));
  const auto gpu = testing::make_device_engine(balls);
  ASSERT_TRUE(gpu);
  for (const bool tetrahedra_only : {true, false}) {
    std::size_t before = 0;
    for (int move = 0; move <= 12; ++move) {
      const double alpha = balls->lattice.square_angstrom(2e5 + 2e4 * move);
      const AlphaComplex complex = gpu->compute({alpha, tetrahedra_only}, {});
      EXPECT_GT(complex.tetrahedra.size(), before);
      before = complex.tetrahedra.size();
      if (move == 0) continue;
      for (const EngineCounter& counter : complex.engine.counters) {
        EXPECT_NE(counter.name, "runs, repeated for lack of memory")
            << counter.value << ", move " << move;
      }
    }
  }
}

TEST(Gpu, EqualsItselfFromRunToRun) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(6);
  const auto sets = testing::large_hard_sets(random);
  const auto balls = std::make_shared<const BallSet>(sets.front().balls);
  const auto engine = testing::make_device_engine(balls);
  ASSERT_TRUE(engine);
  const AlphaComplex first = engine->compute({0.5, false}, {});
  for (int run = 0; run < 20; ++run)
    expect_same(engine->compute({0.5, false}, {}).tetrahedra, first.tetrahedra);
}

// A result keeps its memory. Later results reuse that memory once it is freed.
TEST(GpuResults, StayAsTheyAre) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(10);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 600, 8000, 500, 900));
  auto gpu = testing::make_device_engine(balls);
  ASSERT_TRUE(gpu);
  const auto cpu = make_cpu_engine(balls);
  const auto request = [&](int number) {
    return AlphaRequest{balls->lattice.square_angstrom(1e5 * (number % 3)), number % 2 == 0};
  };
  std::vector<AlphaComplex> kept;
  for (int number = 0; number < 12; ++number) {
    kept.push_back(gpu->compute(request(number), {}));
    gpu->compute(request(number + 1), {});  // freed at once
  }
  kept.push_back(kept.front());
  kept.front() = {};
  gpu.reset();
  for (int number = 1; number <= 12; ++number) {
    SCOPED_TRACE(number);
    expect_same(kept[number], cpu->compute(request(number % 12), {}));
  }
}

TEST(GpuLimits, AreWhat32BitsReach) {
  EXPECT_LT(8 * gpu::kMaxBalls + 513, std::size_t{1} << 31) << "cells are counted in int";
  EXPECT_LT(3 * gpu::kMaxSimplices, std::size_t{1} << 32) << "words of triangles";
  const std::size_t counts[] = {0, gpu::kMaxSimplices};
  EXPECT_TRUE(gpu::are_countable(counts));
  const std::size_t more[] = {gpu::kMaxSimplices + 1, 0};
  EXPECT_FALSE(gpu::are_countable(more));
}

// The time of the first run contains that of reserving memory for its result. No stage may have a
// negative time.
TEST(GpuResults, SayWhatTheirMemoryTook) {
  if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  Random random(11);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 600, 8000, 500, 900));
  const auto gpu = testing::make_device_engine(balls);
  ASSERT_TRUE(gpu);
  for (int run = 0; run < 3; ++run) {
    const AlphaComplex complex = gpu->compute({balls->lattice.square_angstrom(1e5), false}, {});
    int reserved = 0;
    for (const StageTime& stage : complex.timings.stages) {
      EXPECT_GE(stage.milliseconds, 0) << stage.label;
      if (stage.label == stage::kMakingRoom) ++reserved;
    }
    if (run == 0) {
      EXPECT_GT(reserved, 0);
    }
  }
}

// CTest runs it with a stand-in for the driver's library that reports an old version
// (old_driver.c).
TEST(Gpu, SaysThatADriverIsTooOld) {
  if (std::getenv("ALPHASCOPE_EXPECT_OLD_DRIVER") == nullptr)
    GTEST_SKIP() << "only with old_driver.c";
  EXPECT_FALSE(gpu_device().usable);
  EXPECT_NE(gpu_device().why_not.find("supports CUDA 10.2, this program needs"), std::string::npos)
      << gpu_device().why_not;
  EXPECT_NE(gpu_device().why_not.find("update the driver"), std::string::npos)
      << gpu_device().why_not;
}

TEST(Gpu, SaysWhyItCannotBeUsed) {
  const GpuDevice& device = gpu_device();
  if (device.usable) GTEST_SKIP() << device.name << " is usable";
  EXPECT_NE(device.why_not.find("CPU engine"), std::string::npos) << device.why_not;
  BallSet balls;
  balls.centres.push_back({0, 0, 0});
  balls.radii.push_back(1000);
  std::string why_not;
  EXPECT_EQ(testing::make_gpu_engine(std::make_shared<const BallSet>(balls), {}, &why_not),
            nullptr);
  EXPECT_EQ(why_not, device.why_not);
}

}  // namespace
}  // namespace alphascope
