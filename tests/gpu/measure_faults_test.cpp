// SPDX-License-Identifier: GPL-3.0-or-later
// Tests areas and volumes on the emulated device: for a complex that is still there from its run.
// The device may be full or lost at any moment.
#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/engine_measures.hpp"
#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/measure/union_measurer.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/gpu/emulated/device.h"
#include "tests/support/device_engine.hpp"

namespace alphascope {
namespace {

using testing::complex_of;
using testing::Random;
using testing::random_balls;

// In one chunk and in several, and after runs that left room in the buffers.
TEST(GpuMeasureOnDevice, IsThatOfTheUploadedComplex) {
  Random random(3);
  const BallSet balls = random_balls(random, 150, 1000, 100, 300);
  gpu::UnionMeasurer measurer;
  for (const int chunks : {1, 4}) {
    gpu::DualEdgePipeline pipeline(balls, chunks);
    EXPECT_FALSE(pipeline.on_device());
    for (const double alpha : {-0.01, 0.05, 0.02, 0.02, 0.3, 0.0}) {
      const AlphaComplex complex = complex_of(balls, alpha);
      pipeline.run(complex.alpha_on_lattice, false, {}, nullptr);
      const auto there = pipeline.on_device();
      ASSERT_TRUE(there);
      const UnionMeasures expected = measure_union(balls, complex, {1});
      UnionMeasures found;
      measurer.measure(*there, {}, nullptr).copy_to(found);
      EXPECT_NEAR(found.area_angstrom2(), expected.area_angstrom2(),
                  1e-12 * expected.area_angstrom2());
      UnionMeasures again;
      measurer.measure(measurer.upload(balls, complex, {}), {}, nullptr).copy_to(again);
      EXPECT_EQ(found.total, again.total);
      EXPECT_EQ(found.of_ball, again.of_ball);
    }
    pipeline.run(0, true, {}, nullptr);
    EXPECT_FALSE(pipeline.on_device()) << "tetrahedra alone";
  }
}

class GpuMeasureFaults : public ::testing::Test {
 protected:
  void TearDown() override { emulated::be_sound(); }
  static BallSet some_balls(int count) {
    Random random(45);
    return random_balls(random, count, 1000, 100, 300);
  }
  // After every fault it must measure as without faults. Returns the number of faults.
  template <class Fault, class Expect>
  int measure_with(const Fault& fault, const Expect& is_said) {
    const BallSet small = some_balls(8), large = some_balls(40);
    const AlphaComplex first = complex_of(small), later = complex_of(large);
    const double expected = measure_union(large, later, {1}).area_angstrom2();
    for (int n = 0;; ++n) {
      const auto measurer = make_gpu_measurer(nullptr);
      UnionMeasures of;
      measurer->measure(small, first, of);
      fault(n);
      try {
        measurer->measure(large, later, of);
        EXPECT_EQ(emulated::faults_met(), 0) << "nothing was said of " << n;
      } catch (const std::exception& error) {
        EXPECT_GT(emulated::faults_met(), 0);
        EXPECT_TRUE(is_said(error)) << error.what();
      }
      const bool met = emulated::faults_met() > 0;
      emulated::be_sound();
      measurer->measure(large, later, of);
      EXPECT_NEAR(of.area_angstrom2(), expected, 1e-12 * expected) << "after " << n;
      if (!met) return n;
    }
  }
};

TEST_F(GpuMeasureFaults, ARefusedReservationIsSaid) {
  const int met = measure_with(emulated::be_full_at, [](const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  });
  EXPECT_GT(met, 10);
}

TEST_F(GpuMeasureFaults, ALostDeviceIsSaid) {
  const int met = measure_with(emulated::be_lost_at, [](const std::exception& error) {
    return std::string(error.what()).find("the GPU failed while") == 0;
  });
  EXPECT_GT(met, 30);
}

// The engine's answer has the CPU's numbers and says so. Later it measures on the device again.
class GpuEngineMeasureFaults : public GpuMeasureFaults {
 protected:
  template <class Fault>
  int measure_by_engine(const Fault& fault, const std::string& said) {
    const auto balls = std::make_shared<const BallSet>(some_balls(40));
    WorkThreads threads(1);
    for (int n = 0;; ++n) {
      const auto engine = testing::make_gpu_engine(balls, {}, nullptr);
      const AlphaComplex complex = engine->compute({0.1}, {});
      const UnionMeasures expected = measure_union(*balls, complex, {1});
      fault(n);
      const auto found = measure_on_device(*engine, *balls, complex, threads, {});
      const bool met = emulated::faults_met() > 0;
      emulated::be_sound();
      EXPECT_TRUE(found);
      EXPECT_NEAR(found->measures.area_angstrom2(), expected.area_angstrom2(),
                  1e-12 * expected.area_angstrom2());
      if (met) {
        EXPECT_EQ(found->measures.ball_area_angstrom2(), expected.ball_area_angstrom2());
        EXPECT_EQ(found->device, "CPU, 1 thread");
        EXPECT_NE(found->note.find("on the CPU: " + said), std::string::npos) << found->note;
      }
      engine->compute({0.1}, {});
      const auto again = measure_on_device(*engine, *balls, complex, threads, {});
      EXPECT_EQ(again->device, gpu_device().name) << "after " << n << ": " << again->note;
      if (!met) return n;
    }
  }
};

TEST_F(GpuEngineMeasureFaults, AFullDeviceLeavesItToTheCpu) {
  EXPECT_GT(measure_by_engine(emulated::be_full_at, "the GPU's memory is full."), 5);
}

TEST_F(GpuEngineMeasureFaults, ALostDeviceLeavesItToTheCpu) {
  EXPECT_GT(measure_by_engine(emulated::be_lost_at, "the GPU failed while"), 10);
}

// Memory that an engine keeps for measuring must not force its next complex into slabs.
TEST_F(GpuEngineMeasureFaults, MemoryForMeasuringIsGivenBackToTheComplex) {
  const auto balls = std::make_shared<const BallSet>(some_balls(200));
  WorkThreads threads(1);
  const auto engine = testing::make_gpu_engine(balls, {}, nullptr);
  measure_on_device(*engine, *balls, engine->compute({-0.05}, {}), threads, {});
  AlphaComplex later;
  for (const double alpha : {0.0, 0.05, 0.1, 0.2, 0.4}) {  // until it needs more memory
    emulated::be_full_at(0);
    later = engine->compute({alpha}, {});
    if (emulated::faults_met() > 0) break;
  }
  EXPECT_GT(emulated::faults_met(), 0);
  emulated::be_sound();
  EXPECT_EQ(later.engine.route.find("slabs"), std::string::npos) << later.engine.route;
}

TEST_F(GpuMeasureFaults, ADeviceLostFromTheStartIsAReason) {
  ASSERT_TRUE(gpu_device().usable);
  emulated::be_lost_at(0);
  std::string why_not;
  EXPECT_EQ(make_gpu_measurer(&why_not), nullptr);
  EXPECT_NE(why_not.find("cannot be used"), std::string::npos) << why_not;
}

}  // namespace
}  // namespace alphascope
