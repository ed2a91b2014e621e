// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the search for outer faces when the emulated device is full or lost at any moment. Then
// there is no result, and the engine goes on.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/triangulation/outer_faces.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/gpu/emulated/device.h"
#include "tests/support/device_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

class GpuOutsideFaults : public ::testing::Test {
 protected:
  void TearDown() override { emulated::be_sound(); }

  // `fault(n)` sets the fault at its n-th chance. Returns the number of faults that occurred.
  template <class Fault>
  int find_with(const Fault& fault) {
    Random random(46);
    const auto balls =
        std::make_shared<const BallSet>(testing::random_balls(random, 40, 400, 100, 300));
    for (int n = 0;; ++n) {
      std::string why_not;
      const auto engine = testing::make_gpu_engine(balls, {}, &why_not);
      AlphaComplex complex = engine->compute({0.02}, {});
      EXPECT_GT(complex.tetrahedra.size(), 10u);
      fault(n);
      const auto found = engine->find_outer_faces(complex);
      const bool met = emulated::faults_met() > 0;
      emulated::be_sound();
      EXPECT_EQ(found.has_value(), !met) << n;
      complex = engine->compute({0.03}, {});
      complex.outside = engine->find_outer_faces(complex);
      EXPECT_TRUE(complex.outside) << "after " << n;
      EXPECT_EQ(outer_faces(complex), outer_faces(complex.tetrahedra.simplices)) << n;
      if (!met || HasFailure()) return n;
    }
  }
};

TEST_F(GpuOutsideFaults, WhenMemoryIsFull) {
  EXPECT_GE(find_with(emulated::be_full_at), 6);
}

TEST_F(GpuOutsideFaults, WhenTheDeviceIsLost) {
  EXPECT_GE(find_with(emulated::be_lost_at), 8);
}

}  // namespace
}  // namespace alphascope
