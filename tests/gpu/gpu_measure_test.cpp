// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that areas and volumes on the device equal the CPU's up to rounding, with the same bits
// each time.
#include "gpu/measure/gpu_measure.hpp"

#include <gtest/gtest.h>

#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/ball_geometry.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::balls_of_file;
using testing::complex_of;
using testing::NamedBalls;
using testing::Random;

constexpr double kNear = 1e-12;  // relative; for a ball to its sphere and its whole volume
// The same for arcs, relative to a great circle. Where spheres just touch, half of the digits
// count.
constexpr double kNearArcs = 1e-6;

class GpuMeasure : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
    std::string why_not;
    measurer_ = make_gpu_measurer(&why_not);
    ASSERT_TRUE(measurer_) << why_not;
  }

  void expect_those_of_the_cpu(const BallSet& balls, double alpha) {
    const AlphaComplex complex = complex_of(balls, alpha);
    const UnionMeasures expected = measure_union(balls, complex, {1});
    UnionMeasures found;
    measurer_->measure(balls, complex, found);
    EXPECT_NEAR(found.area_angstrom2(), expected.area_angstrom2(),
                kNear * expected.area_angstrom2());
    EXPECT_NEAR(found.volume_angstrom3(), expected.volume_angstrom3(),
                kNear * expected.volume_angstrom3());
    ASSERT_EQ(found.ball_area_angstrom2().size(), balls.size());
    ASSERT_EQ(found.ball_volume_angstrom3().size(), balls.size());
    const double unit = balls.lattice.unit_angstrom();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double radius =
          unit *
          grown_ball(balls.centres[i], balls.radii[i], complex.alpha_on_lattice).grown_radius;
      EXPECT_NEAR(found.ball_area_angstrom2()[i], expected.ball_area_angstrom2()[i],
                  kNear * sphere_area(radius))
          << i;
      EXPECT_NEAR(found.ball_volume_angstrom3()[i], expected.ball_volume_angstrom3()[i],
                  kNear * ball_volume(radius))
          << i;
      EXPECT_NEAR(found.of_ball[MeasuredQuantity::arc_length][i],
                  expected.of_ball[MeasuredQuantity::arc_length][i], kNearArcs * 2 * kPi * radius)
          << i;
    }
#ifdef ALPHASCOPE_EMULATED_DEVICE
    EXPECT_EQ(found.of_ball, expected.of_ball) << "the same code on the same processor";
#endif
    UnionMeasures again;
    measurer_->measure(balls, complex, again);
    EXPECT_EQ(again.total, found.total);
    EXPECT_EQ(again.of_ball, found.of_ball);
  }

  std::unique_ptr<GpuMeasurer> measurer_;
};

TEST_F(GpuMeasure, OfNoBallAreNothing) {
  UnionMeasures of;
  each_quantity([&](MeasuredQuantity q) {
    of.total[q] = 1;
    of.of_ball[q] = {1, 2};
  });
  measurer_->measure(BallSet{}, complex_of(BallSet{}), of);
  EXPECT_EQ(of.area_angstrom2(), 0);
  EXPECT_EQ(of.volume_angstrom3(), 0);
  EXPECT_TRUE(of.ball_area_angstrom2().empty());
  EXPECT_TRUE(of.ball_volume_angstrom3().empty());
}

// One and two balls, hidden and equal ones, and a set after a larger one.
TEST_F(GpuMeasure, OfFewBallsAreThoseOfTheCpu) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& row : {std::array{0, 0, 0, 3}, std::array{4, 0, 0, 2}, std::array{0, 0, 1, 1},
                          std::array{0, 0, 0, 3}, std::array{0, 5, 0, 2}, std::array{9, 0, 0, 1}}) {
    add_ball(balls, row[0], row[1], row[2], row[3]);
    for (const double alpha : {-9.5, -4.0, -1.0, 0.0, 2.0}) expect_those_of_the_cpu(balls, alpha);
  }
}

TEST_F(GpuMeasure, OfTrapsAreThoseOfTheCpu) {
  std::ifstream table(testing::measure_data("traps.tsv"));
  std::string name, area, volume;
  table >> name >> area >> volume;
  int sets = 0;
  while (table >> name >> area >> volume) {
    SCOPED_TRACE(name);
    const BallSet balls = balls_of_file(name + ".xyzr");
    for (const double alpha : {-0.5, 0.0, 1.5}) expect_those_of_the_cpu(balls, alpha);
    ++sets;
  }
  EXPECT_EQ(sets, 15);
}

TEST_F(GpuMeasure, OfHardSetsAreThoseOfTheCpu) {
  Random random(61);
  for (const NamedBalls& set : testing::large_hard_sets(random, 150)) {
    SCOPED_TRACE(set.name);
    for (const double alpha : {0.0, 3.0}) {
      expect_those_of_the_cpu(set.balls, alpha * set.alpha_unit());
      if (HasFailure()) return;
    }
  }
  for (const int factor : {1, 5, 40}) {
    SCOPED_TRACE(factor);
    expect_those_of_the_cpu(testing::balls_through_a_point(random, 30, factor), 0);
  }
}

TEST_F(GpuMeasure, OfAProteinAreThoseOfTheCpu) {
  for (const double solvent : {0.0, 1.4}) {
    const BallSet balls = with_solvent(balls_of_file("1crn.xyzr"), solvent);
    for (const double alpha : {0.0, 5.0}) expect_those_of_the_cpu(balls, alpha);
  }
}

TEST_F(GpuMeasure, RefusesWhatTheCpuRefuses) {
  const BallSet balls = balls_of_file("tangent3.xyzr");
  AlphaComplex complex = complex_of(balls);
  UnionMeasures of;
  BallSet fewer = balls;
  fewer.centres.pop_back();
  fewer.radii.pop_back();
  EXPECT_THROW(measurer_->measure(fewer, complex, of), std::invalid_argument);
  complex.tetrahedra_only = true;
  EXPECT_THROW(measurer_->measure(balls, complex, of), std::invalid_argument);
}

TEST_F(GpuMeasure, CanBeCancelled) {
  const BallSet balls = balls_of_file("tangent3.xyzr");
  RunContext context;
  context.cancel.cancel();
  UnionMeasures of;
  EXPECT_THROW(measurer_->measure(balls, complex_of(balls), of, context), Cancelled);
}

}  // namespace
}  // namespace alphascope
