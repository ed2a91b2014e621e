// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the device finds the same outer faces of tetrahedra as the CPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/triangulation/outer_faces.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/device_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::balls_of_file;
using testing::NamedBalls;
using testing::Random;

class GpuOutside : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
  }

  // Returns the number of all faces.
  std::size_t expect_that_of_the_cpu(const BallSet& balls, const std::vector<double>& alphas,
                                     int chunks = 0) {
    const auto set = std::make_shared<const BallSet>(balls);
    std::string why_not;
    const auto engine = testing::make_gpu_engine(set, {}, &why_not, {chunks});
    EXPECT_TRUE(engine) << why_not;
    std::size_t all = 0;
    for (const double alpha : alphas) {
      AlphaComplex complex = engine->compute({alpha}, {});
      const auto expected = outer_faces(complex.tetrahedra.simplices);
      complex.outside = engine->find_outer_faces(complex);
      const bool by_cpu = complex.engine.route.find("on the CPU") != std::string::npos;
      EXPECT_NE(complex.outside.has_value(), by_cpu) << alpha;
      if (!complex.outside) continue;
      const auto& faces = complex.outside->faces;
      EXPECT_TRUE(std::equal(faces.begin(), faces.end(), expected.begin(), expected.end()))
          << alpha << ": " << faces.size() << " faces, of " << expected.size();
      const auto shared = outer_faces(complex);
      EXPECT_EQ(shared, expected);
      EXPECT_TRUE(shared.empty() || shared.data() == faces.data()) << "a copy";
      all += expected.size();
    }
    return all;
  }
};

TEST_F(GpuOutside, OfHardSetsIsThatOfTheCpu) {
  Random random(77);
  std::size_t all = 0;
  for (const NamedBalls& set : testing::large_hard_sets(random, 80)) {
    SCOPED_TRACE(set.name);
    const double unit = set.alpha_unit();
    for (const int chunks : {1, 3}) {
      all += expect_that_of_the_cpu(set.balls, {-unit, 0, 3 * unit, unit}, chunks);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(all, 1000u);
}

TEST_F(GpuOutside, OfAProteinIsThatOfTheCpu) {
  const BallSet balls = balls_of_file("1crn.xyzr");
  EXPECT_GT(expect_that_of_the_cpu(balls, {0, 5, 1, 1000, -2}), 1000u);
}

TEST_F(GpuOutside, OfFewBallsIsThatOfTheCpu) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& row : {std::array{0, 0, 0, 3}, std::array{4, 0, 0, 3}, std::array{0, 4, 0, 3},
                          std::array{0, 0, 4, 3}, std::array{4, 4, 4, 3}}) {
    testing::add_ball(balls, row[0], row[1], row[2], row[3]);
    expect_that_of_the_cpu(balls, {0, 100});
  }
}

TEST_F(GpuOutside, IsOfTheLastWholeComplexOnly) {
  const auto balls = std::make_shared<const BallSet>(balls_of_file("1crn.xyzr"));
  std::string why_not;
  const auto engine = testing::make_gpu_engine(balls, {}, &why_not);
  ASSERT_TRUE(engine) << why_not;
  AlphaComplex none;
  EXPECT_FALSE(engine->find_outer_faces(none));
  const AlphaComplex first = engine->compute({1.0}, {}), second = engine->compute({2.0}, {});
  EXPECT_FALSE(engine->find_outer_faces(first));
  EXPECT_TRUE(engine->find_outer_faces(second));
  const AlphaComplex tetrahedra = engine->compute({2.0, true}, {});
  EXPECT_FALSE(engine->find_outer_faces(tetrahedra));
}

// The faces may be drawn after the engine has gone.
TEST_F(GpuOutside, OutlivesTheEngine) {
  const auto balls = std::make_shared<const BallSet>(balls_of_file("1crn.xyzr"));
  std::string why_not;
  auto engine = testing::make_gpu_engine(balls, {}, &why_not);
  ASSERT_TRUE(engine) << why_not;
  AlphaComplex complex = engine->compute({2.0}, {});
  complex.outside = engine->find_outer_faces(complex);
  const auto drawn = outer_faces(complex);
  engine->compute({1.0}, {});
  engine.reset();
  EXPECT_EQ(drawn, outer_faces(complex.tetrahedra.simplices));
}

}  // namespace
}  // namespace alphascope
