// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that wrapping completes CGAL's triangulation from any part of it.
#include "gpu/wrapping/wrapping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/triangulation/cgal_triangulation.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::balls_of_file;
using testing::NamedBalls;
using testing::Random;
using Tetrahedra = std::vector<std::array<BallIndex, 4>>;

class GpuWrapping : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  }

  // The cube root of the volume for each ball.
  static double typical_radius(const BallSet& balls) {
    double volume = 1;
    for (const auto axis : {&LatticePoint::x, &LatticePoint::y, &LatticePoint::z}) {
      const auto [low, high] =
          std::ranges::minmax(balls.centres, {}, [=](const LatticePoint& p) { return p.*axis; });
      volume *= high.*axis - low.*axis + 1.0;
    }
    return std::cbrt(volume / static_cast<double>(balls.size()));
  }

  // Completes the triangulation from every `step`-th of its tetrahedra, and from the first alone.
  // Returns the number of those found.
  static std::size_t expect_cgal(const BallSet& balls, std::size_t step) {
    const Triangulation whole = make_cgal_triangulation(balls, 1);
    if (whole.dimension < 3) return 0;
    const Tetrahedra expected(whole.tetrahedra.begin(), whole.tetrahedra.end());
    gpu::Wrapping wrapping(balls);
    std::size_t all = 0;
    const double radius = typical_radius(balls);
    for (const bool one : {true, false}) {
      Tetrahedra known;
      for (std::size_t t = 0; t < expected.size(); t += step) {
        if (t == 0 || !one) known.push_back(expected[t]);
      }
      const gpu::WrappingResult result =
          wrapping.run(known, radius, expected.size() + 64, true, CancelToken{});
      EXPECT_TRUE(result.fits);
      Tetrahedra got = result.found;
      got.insert(got.end(), known.begin(), known.end());
      std::sort(got.begin(), got.end());
      EXPECT_EQ(got.size(), expected.size());
      EXPECT_TRUE(got == expected) << balls.size() << " balls, " << known.size() << " known";
      EXPECT_EQ(result.hull, whole.hull.size());
      all += result.found.size();
    }
    return all;
  }
};

TEST_F(GpuWrapping, CompletesHardSets) {
  Random random(78);
  std::size_t all = 0;
  for (const NamedBalls& set : testing::large_hard_sets(random, 120)) {
    SCOPED_TRACE(set.name);
    all += expect_cgal(set.balls, 3);
    if (HasFailure()) return;
  }
  EXPECT_GT(all, 1000u);
}

TEST_F(GpuWrapping, CompletesSmallHardSets) {
  Random random(79);
  std::size_t all = 0;
  for (const NamedBalls& set : testing::small_hard_sets(random, 12)) {
    SCOPED_TRACE(set.name);
    all += expect_cgal(set.balls, 2);
    if (HasFailure()) return;
  }
  EXPECT_GT(all, 100u);
}

TEST_F(GpuWrapping, CompletesAProtein) {
  EXPECT_GT(expect_cgal(balls_of_file("1crn.xyzr"), 2), 1000u);
  EXPECT_GT(expect_cgal(with_solvent(balls_of_file("1crn.xyzr"), 1.4), 2), 1000u);
}

}  // namespace
}  // namespace alphascope
