// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the choice between device and CGAL, and what the report says.
#include "core/triangulation/triangulation_maker.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "core/complex/alpha_complex.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/triangulation_report.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/stand_in_triangulator.hpp"

namespace alphascope {
namespace {

// A maker whose device another thread uses until finish().
struct BusyMaker {
  explicit BusyMaker(const BallSet& balls) : other([this, &balls] { maker.make(balls, 1, {}); }) {
    begun.get_future().wait();
  }
  void finish() {
    end.set_value();
    other.join();
  }

  std::promise<void> begun, end;
  TriangulationMaker maker{[this](std::string&) {
    begun.set_value();
    end.get_future().wait();
    return nullptr;
  }};
  std::thread other;  // after the members that it uses
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
      return std::make_unique<testing::StandInTriangulator>(calls_, why_not);
    });
  }
  testing::TriangulatorCalls calls_;
  BallSet many_, few_;
};

TEST_F(TriangulationMakerTest, TheDeviceMakesThoseOfManyBalls) {
  TriangulationMaker triangulations = maker();
  for (int n = 0; n < 2; ++n) {
    const Triangulation made = triangulations.make(many_, 1, {});
    EXPECT_TRUE(made == make_triangulation(many_, 1));
    ASSERT_TRUE(made.report);
    EXPECT_TRUE(made_by_device(made));
    EXPECT_EQ(made.report->maker, "a device");
    EXPECT_EQ(made.report->waves, 3u);
  }
  EXPECT_EQ(calls_.made, 1);
  EXPECT_EQ(calls_.asked, 2);
}

TEST_F(TriangulationMakerTest, TheCpuMakesThoseOfFewBalls) {
  const Triangulation made = maker().make(few_, 1, {});
  EXPECT_EQ(made.report->by, TriangulationReport::By::insertion);
  EXPECT_EQ(made.report->maker, "CPU, 1 thread");
  EXPECT_EQ(made.report->why_not, "");
  EXPECT_GT(made.report->timings.wall_milliseconds, 0);
  EXPECT_EQ(calls_.made, 0);
}

// Another thread uses the device meanwhile.
// What follows from a triangulation: asked of the device where that pays off, and made by the CPU
// where the device makes none.
TEST_F(TriangulationMakerTest, TheDeviceMakesWhatFollowsFromManyBalls) {
  TriangulationMaker triangulations = maker(), failing = maker("it is broken");
  const Triangulation many = triangulations.make(many_, 1, {}), failed = failing.make(many_, 1, {}),
                      few = make_triangulation(few_, 1);
  EXPECT_FALSE(triangulations.ground(few_, few, FlowTies::strict, {}));
  EXPECT_FALSE(failing.ground(many_, failed, FlowTies::strict, {}));
  EXPECT_EQ(calls_.grounds, 0);
  const auto ground = triangulations.ground(many_, many, FlowTies::strict, {});
  ASSERT_TRUE(ground);
  EXPECT_TRUE(ground->incidence == make_incidence(many));
  EXPECT_EQ(calls_.grounds, 1);
  EXPECT_FALSE(triangulations.membership(ground->incidence, 0.0, {}));
  EXPECT_EQ(calls_.memberships, 1);
  const auto shared = std::make_shared<const Triangulation>(many);
  const auto balls = std::make_shared<const BallSet>(many_);
  const Filtration filtration(balls, shared, {}, &triangulations), expected(balls, shared);
  EXPECT_EQ(calls_.filtrations, 1);
  EXPECT_EQ(filtration.device(), "");
  EXPECT_TRUE(filtration.top().edges.simplices == expected.top().edges.simplices);
  RunContext cancelled;
  cancelled.cancel.cancel();
  EXPECT_THROW(triangulations.filtration_parts(many_, many, cancelled), Cancelled);
}

TEST_F(TriangulationMakerTest, IsCancelledWhileItWaitsForTheDevice) {
  BusyMaker slow(many_);
  RunContext context;
  auto waiting = std::async(std::launch::async,
                            [&] { return slow.maker.make(many_, 1, context).report->waves; });
  EXPECT_EQ(waiting.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout);
  context.cancel.cancel();
  EXPECT_EQ(waiting.wait_for(std::chrono::seconds(20)), std::future_status::ready);
  slow.finish();
  EXPECT_THROW(waiting.get(), Cancelled);
}

// They wait neither for ever nor after a cancel.
TEST_F(TriangulationMakerTest, OthersWaitUntilTheDeviceIsIdle) {
  using std::chrono::milliseconds, std::chrono::seconds;
  TriangulationMaker used = maker();
  used.wait_until_idle(seconds(1000), {});  // there is no device yet
  used.make(many_, 1, {});
  used.wait_until_idle(seconds(1000), {});
  BusyMaker slow(many_);
  slow.maker.wait_until_idle(milliseconds(20), {});
  RunContext context;
  const auto wait = [&](const CancelToken& cancel) {
    slow.maker.wait_until_idle(seconds(1000), cancel);
  };
  std::future<void> waiting = std::async(std::launch::async, wait, CancelToken());
  std::future<void> cancelled = std::async(std::launch::async, wait, context.cancel);
  EXPECT_EQ(waiting.wait_for(milliseconds(50)), std::future_status::timeout);
  context.cancel.cancel();
  EXPECT_THROW(cancelled.get(), Cancelled);
  EXPECT_EQ(waiting.wait_for(milliseconds(0)), std::future_status::timeout);
  slow.finish();
  EXPECT_EQ(waiting.wait_for(seconds(20)), std::future_status::ready);
}

TEST_F(TriangulationMakerTest, KeepsMemoryUntilOthersNeedIt) {
  TriangulationMaker triangulations = maker();
  EXPECT_FALSE(triangulations.release_memory()) << "nothing was made";
  triangulations.make(many_, 1, {});
  EXPECT_EQ(calls_.released, 0);
  EXPECT_TRUE(triangulations.release_memory());
  EXPECT_FALSE(triangulations.release_memory());
  EXPECT_EQ(calls_.released, 1);
  calls_.takes_much_room = true;
  triangulations.make(many_, 1, {});
  EXPECT_EQ(calls_.released, 2);
  EXPECT_FALSE(triangulations.release_memory());
}

TEST_F(TriangulationMakerTest, IsNotNeeded) {
  EXPECT_TRUE(make_triangulation_by(nullptr, many_, 1, {}) == make_triangulation(many_, 1));
  EXPECT_FALSE(made_by_device(make_triangulation_by(nullptr, many_, 1, {})));
}

TEST_F(TriangulationMakerTest, SaysWhyTheDeviceDidNot) {
  const Triangulation made = maker("it is tired").make(many_, 1, {});
  EXPECT_TRUE(made == make_triangulation(many_, 1));
  EXPECT_EQ(made.report->by, TriangulationReport::By::insertion);
  EXPECT_EQ(made.report->why_not, "it is tired");
  EXPECT_EQ(made.report->waves, 0u);
}

TEST_F(TriangulationMakerTest, TheCpuMakesAllWithoutADevice) {
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
  EXPECT_FALSE(rests("it is tired"));
  const auto by_cgal = std::make_shared<const Triangulation>(make_cgal_triangulation(many_, 1));
  EXPECT_TRUE(Filtration(balls, by_cgal, {}).top().engine.rests_on_cgal);
}

}  // namespace
}  // namespace alphascope
