// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the device's triangulation when the emulated device is full or lost at any moment. Then it
// says so, and the next call works.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

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

// The same for what follows from a triangulation.
template <class Fault>
int follow_with(const Fault& fault, const char* words) {
  Random random(98);
  const BallSet balls = testing::random_balls(random, 60, 300, 20, 150);
  const Triangulation whole = make_cgal_triangulation(balls, 1);
  const Incidence expected = make_incidence(whole);
  const auto is_right = [&](const std::optional<FiltrationParts>& parts,
                            const std::optional<TriangulationGround>& ground) {
    return parts && parts->triangles.simplices == expected.triangles && ground &&
           ground->incidence == expected;
  };
  for (int n = 0;; ++n) {
    const auto device = make_gpu_triangulator(seed_tetrahedron);
    fault(n);
    std::string why_not;
    const auto parts = device->filtration_parts(balls, whole, {}, why_not);
    const auto ground = device->ground(balls, whole, FlowTies::perturbed, {}, why_not);
    const bool met = emulated::faults_met() > 0;
    emulated::be_sound();
    EXPECT_TRUE((parts && ground) || met) << n;
    if (parts && ground) {
      EXPECT_TRUE(is_right(parts, ground)) << n;
    } else {
      EXPECT_NE(why_not.find(words), std::string::npos) << why_not;
    }
    const auto next_parts = device->filtration_parts(balls, whole, {}, why_not);
    const auto next_ground = device->ground(balls, whole, FlowTies::perturbed, {}, why_not);
    EXPECT_TRUE(is_right(next_parts, next_ground)) << "after " << n;
    if (!met || ::testing::Test::HasFailure()) return n;
  }
}

TEST_F(GpuTriangulatorFaults, WhenMemoryIsFullForWhatFollows) {
  EXPECT_GE(follow_with(emulated::be_full_at, "too little memory"), 30);
}

TEST_F(GpuTriangulatorFaults, WhenTheDeviceIsLostForWhatFollows) {
  EXPECT_GE(follow_with(emulated::be_lost_at, "the GPU failed while"), 60);
}

TEST_F(GpuTriangulatorFaults, WhenMemoryIsFull) {
  EXPECT_GE(make_with(emulated::be_full_at, "too little memory"), 40);
}

TEST_F(GpuTriangulatorFaults, WhenTheDeviceIsLost) {
  EXPECT_GE(make_with(emulated::be_lost_at, "the GPU failed while"), 60);
}

}  // namespace
}  // namespace alphascope
