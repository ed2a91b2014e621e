// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the device's triangulation when the emulated device is full or lost at any moment. Then it
// says so, and the next call works.
#include <gtest/gtest.h>

#include <memory>

#include "core/triangulation/cgal_triangulation.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/wrapping/triangulator.hpp"
#include "tests/gpu/emulated/device.h"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

class GpuTriangulatorFaults : public ::testing::Test {
 protected:
  void TearDown() override { emulated::be_sound(); }

  // `fault(n)` sets the fault at its n-th chance. Returns the number of faults that occurred.
  template <class Fault>
  int make_with(const Fault& fault, const char* words) {
    Random random(97);
    const BallSet balls = testing::random_balls(random, 60, 300, 20, 150);
    const Triangulation expected = make_cgal_triangulation(balls, 1);
    for (int n = 0;; ++n) {
      const auto triangulator = make_gpu_triangulator(seed_tetrahedron);
      fault(n);
      const DeviceTriangulation made = triangulator->make(balls, {});
      const bool met = emulated::faults_met() > 0;
      emulated::be_sound();
      EXPECT_TRUE(made.triangulation || met) << n;
      if (made.triangulation) {
        EXPECT_TRUE(*made.triangulation == expected) << n;
      } else {
        EXPECT_NE(made.report.why_not.find(words), std::string::npos) << made.report.why_not;
      }
      const DeviceTriangulation next = triangulator->make(balls, {});
      EXPECT_TRUE(next.triangulation && *next.triangulation == expected) << "after " << n;
      if (!met || HasFailure()) return n;
    }
  }
};

TEST_F(GpuTriangulatorFaults, WhenMemoryIsFull) {
  EXPECT_GE(make_with(emulated::be_full_at, "too little memory"), 40);
}

TEST_F(GpuTriangulatorFaults, WhenTheDeviceIsLost) {
  EXPECT_GE(make_with(emulated::be_lost_at, "the GPU failed while"), 60);
}

}  // namespace
}  // namespace alphascope
