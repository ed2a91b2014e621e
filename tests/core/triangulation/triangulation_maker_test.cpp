// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the choice between device and CGAL, and what the report says.
#include "core/triangulation/triangulation_maker.hpp"

#include <gtest/gtest.h>

#include "core/complex/alpha_complex.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

struct Calls {
  int made = 0, asked = 0, released = 0;
};

// A device whose triangulations are CGAL's, or which makes none.
class Device : public DeviceTriangulator {
 public:
  Device(Calls& calls, std::string why_not) : calls_(calls), why_not_(std::move(why_not)) {}
  DeviceTriangulation make(const BallSet& balls, const RunContext& context) override {
    ++calls_.asked;
    context.cancel.throw_if_cancelled();
    DeviceTriangulation made;
    made.report.maker = "a device";
    made.report.rounds = 3;
    made.report.why_not = why_not_;
    if (why_not_.empty()) made.triangulation = make_triangulation(balls, 1);
    return made;
  }
  void release_memory() override { ++calls_.released; }

 private:
  Calls& calls_;
  std::string why_not_;
};

class TriangulationMakerTest : public ::testing::Test {
 protected:
  TriangulationMakerTest() {
    testing::Random random(96);
    many_ = testing::random_balls(random, 2500, 4000, 100, 200);
    few_ = testing::random_balls(random, 100, 1000, 100, 200);
  }
  TriangulationMaker maker(const std::string& why_not = {}) {
    return TriangulationMaker([this, why_not](std::string&) {
      ++calls_.made;
      return std::make_unique<Device>(calls_, why_not);
    });
  }
  Calls calls_;
  BallSet many_, few_;
};

TEST_F(TriangulationMakerTest, TheDeviceMakesThoseOfManyBalls) {
  TriangulationMaker triangulations = maker();
  for (int n = 0; n < 2; ++n) {
    const Triangulation made = triangulations.make(many_, 1, {});
    EXPECT_TRUE(made == make_triangulation(many_, 1));
    ASSERT_TRUE(made.report);
    EXPECT_FALSE(made.report->by_cgal);
    EXPECT_EQ(made.report->maker, "a device");
    EXPECT_EQ(made.report->rounds, 3u);
  }
  EXPECT_EQ(calls_.made, 1);
  EXPECT_EQ(calls_.asked, 2);
}

TEST_F(TriangulationMakerTest, CgalMakesThoseOfFewBalls) {
  const Triangulation made = maker().make(few_, 1, {});
  EXPECT_TRUE(made.report->by_cgal);
  EXPECT_EQ(made.report->maker, "CGAL");
  EXPECT_EQ(made.report->why_not, "");
  EXPECT_GT(made.report->timings.wall_milliseconds, 0);
  EXPECT_EQ(calls_.made, 0);
}

TEST_F(TriangulationMakerTest, SaysWhyTheDeviceDidNot) {
  const Triangulation made = maker("it is tired").make(many_, 1, {});
  EXPECT_TRUE(made == make_triangulation(many_, 1));
  EXPECT_TRUE(made.report->by_cgal);
  EXPECT_EQ(made.report->why_not, "it is tired");
  EXPECT_EQ(made.report->rounds, 0u);
}

TEST_F(TriangulationMakerTest, CgalMakesAllWithoutADevice) {
  TriangulationMaker none([](std::string& why_not) {
    why_not = "it is broken";
    return nullptr;
  });
  EXPECT_EQ(none.make(many_, 1, {}).report->why_not, "it is broken");
  EXPECT_EQ(TriangulationMaker(nullptr).make(many_, 1, {}).report->why_not, "");
}

TEST_F(TriangulationMakerTest, IsCancelled) {
  RunContext cancelled;
  cancelled.cancel.cancel();
  EXPECT_THROW(maker().make(many_, 1, cancelled), Cancelled);
}

// A result of a device is compared with CGAL as an independent one.
TEST_F(TriangulationMakerTest, OnlyCgalsTriangulationsRestOnCgal) {
  const auto balls = std::make_shared<const BallSet>(many_);
  const auto rests = [&](const std::string& why_not) {
    const auto made = std::make_shared<const Triangulation>(maker(why_not).make(many_, 1, {}));
    return Filtration(balls, made, {}).top().engine.rests_on_cgal;
  };
  EXPECT_FALSE(rests(""));
  EXPECT_TRUE(rests("it is tired"));
}

}  // namespace
}  // namespace alphascope
