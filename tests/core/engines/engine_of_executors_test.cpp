// SPDX-License-Identifier: GPL-3.0-or-later
// Tests an engine whose executor has little memory, fails, or cannot compute. The executors here
// compute with the CPU engine, and imitate only the limits of a device.
#include "core/engines/engine_of_executors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/complex/triangulation.hpp"
#include "core/engine/known_results.hpp"
#include "core/measure/union_measures.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "tests/support/expect_same.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/stand_in_triangulator.hpp"

namespace alphascope {
namespace {

using testing::Random;

struct Device {
  std::size_t room = ~std::size_t{0};  // balls; larger sets find no memory
  bool lost = false, beyond = false;
  bool full = false;               // for measures and the outside
  std::vector<std::size_t> asked;  // balls of each requested set
  int made = 0, rested = 0;
};

class SmallExecutor : public Executor {
 public:
  SmallExecutor(std::shared_ptr<const BallSet> balls, Device& device)
      : balls_(std::move(balls)), device_(device) {
    ++device_.made;
  }
  std::optional<AlphaComplex> compute(const AlphaRequest& request,
                                      const RunContext& context) override {
    device_.asked.push_back(balls_->size());
    if (device_.lost) throw ExecutorFailed("the device is lost");
    if (device_.beyond) return std::nullopt;
    if (balls_->size() > device_.room) throw std::bad_alloc();
    AlphaComplex complex = make_cpu_engine(balls_, {1})->compute(request, context);
    complex.engine.route = "device";
    return complex;
  }
  DeviceMeasuring measure(const AlphaComplex&, UnionMeasures&, const RunContext&) override {
    fail_where_it_must();
    return {"device", "", ""};
  }
  std::optional<SharedFaces> find_outer_faces(const AlphaComplex&) override {
    fail_where_it_must();
    return SharedFaces{};
  }
  void release_memory() override { ++device_.rested; }

 private:
  void fail_where_it_must() const {
    if (device_.lost) throw ExecutorFailed("the device is lost");
    if (device_.full) throw std::bad_alloc();
  }

  std::shared_ptr<const BallSet> balls_;
  Device& device_;
};

class ShortOfMemory : public ::testing::Test {
 protected:
  ShortOfMemory() {
    Random random(61);
    balls_ = std::make_shared<const BallSet>(testing::random_balls(random, 600, 10000, 300, 500));
    engine_ = make_engine_of_executors(balls_, {1}, [this](auto balls) {
      return std::make_unique<SmallExecutor>(std::move(balls), device_);
    });
  }

  // The route of a result, which must be right by every route.
  std::string route(double alpha, bool tetrahedra_only = false) {
    const AlphaComplex found = engine_->compute({alpha, tetrahedra_only}, {});
    testing::expect_same(found,
                         make_cpu_engine(balls_, {1})->compute({alpha, tetrahedra_only}, {}));
    return found.engine.route;
  }

  Device device_;
  std::shared_ptr<const BallSet> balls_;
  std::unique_ptr<Engine> engine_;
};

TEST_F(ShortOfMemory, AnExecutorWithRoomIsMadeOnce) {
  EXPECT_EQ(route(100), "device");
  EXPECT_EQ(route(1e5), "device");
  EXPECT_EQ(device_.made, 1);
  engine_->release_memory();
  EXPECT_EQ(device_.rested, 1);
}

TEST_F(ShortOfMemory, TakesAsFewSlabsAsThereIsRoomFor) {
  device_.room = 250;
  EXPECT_EQ(route(1e5), "device, in 4 slabs");
  device_.asked.clear();
  EXPECT_EQ(route(2e5), "device, in 4 slabs") << "nor tried in vain again";
  EXPECT_EQ(device_.asked.size(), 4u);
}

TEST_F(ShortOfMemory, TriesFewerSlabsForLessAndOnceInAWhile) {
  device_.room = 250;
  route(1e5);
  device_.room = ~std::size_t{0};
  EXPECT_EQ(route(9e4), "device, in 2 slabs");
  EXPECT_EQ(route(9e4, true), "device") << "tetrahedra alone need less";
  device_.room = 350;
  EXPECT_EQ(route(2e5), "device, in 2 slabs");
  device_.room = ~std::size_t{0};
  for (int n = 0; n < 7; ++n) EXPECT_EQ(route(2e5), "device, in 2 slabs");
  EXPECT_EQ(route(2e5), "device") << "others may have had the memory";
}

TEST_F(ShortOfMemory, TheCpuComputesWhatNoNumberOfSlabsHasRoomFor) {
  device_.room = 0;
  EXPECT_NE(route(1e5).find("(on the CPU: the GPU's memory is full)"), std::string::npos);
  device_.room = ~std::size_t{0};
  int answers = 0;
  while (route(2e5) != "device" && answers < 100) ++answers;
  EXPECT_LT(answers, 100) << "the device is not asked any more";
}

TEST_F(ShortOfMemory, TheCpuComputesAndSaysWhyWhenADeviceIsLost) {
  route(100);
  device_.lost = true;
  EXPECT_NE(route(200).find("(on the CPU: the device is lost)"), std::string::npos);
  device_.lost = false;
  EXPECT_EQ(route(300), "device");
  EXPECT_EQ(device_.made, 2) << "a lost device's executor was used again";
}

TEST_F(ShortOfMemory, TheCpuComputesWhatIsBeyondTheLimits) {
  device_.beyond = true;
  EXPECT_NE(route(100).find("(on the CPU: beyond the GPU kernels' limits)"), std::string::npos);
  device_.beyond = false;
  device_.room = 350;
  route(1e5);
  device_.beyond = true;  // for a slab
  EXPECT_NE(route(2e5).find("beyond the GPU kernels' limits"), std::string::npos);
  EXPECT_THROW(engine_->compute({std::nan("")}, {}), std::invalid_argument);
}

// At a large alpha only the triangulation comes from the device. It is the device's own, so CGAL's
// complex is independent of it.
TEST_F(ShortOfMemory, TheDeviceMakesTheTriangulationOfWhatIsBeyondTheLimits) {
  testing::TriangulatorCalls calls;
  const auto maker = [&](const std::string& why_not) {
    return std::make_shared<TriangulationMaker>([&calls, why_not](std::string&) {
      return std::make_unique<testing::StandInTriangulator>(calls, why_not);
    });
  };
  Random random(62);
  balls_ = std::make_shared<const BallSet>(testing::random_balls(random, 2500, 10000, 300, 500));
  for (const std::string why_not : {"", "it is tired"}) {
    device_.beyond = true;
    engine_ = make_engine_of_executors(balls_, {1, {}, maker(why_not)}, [this](auto balls) {
      return std::make_unique<SmallExecutor>(std::move(balls), device_);
    });
    constexpr double kAll = 1e12;
    KnownResults known;
    for (const bool tetrahedra_only : {true, false}) {
      const AlphaComplex found = engine_->compute({kAll, tetrahedra_only}, known, {});
      testing::expect_same(found,
                           make_cgal_engine(balls_, {1})->compute({kAll, tetrahedra_only}, {}));
      EXPECT_TRUE(found.engine.of_whole);
      EXPECT_FALSE(found.engine.rests_on_cgal);
      const std::string all =
          why_not.empty()
              ? "regular triangulation on a device, then threshold (the rest on the CPU: "
              : "regular triangulation, then threshold (on the CPU: ";
      const std::string more =
          "filtration of the whole triangulation, then threshold (on the CPU: ";
      EXPECT_EQ(found.engine.route,
                (tetrahedra_only ? all : more) + "beyond the GPU kernels' limits)");
    }
    EXPECT_EQ(calls.asked, 1);
    // An executor short of memory first gets what triangulations keep.
    device_.beyond = false;
    device_.room = 0;
    calls = {};
    engine_->compute({kAll}, {});
    EXPECT_EQ(calls.released, 1);
    device_.room = ~std::size_t{0};
    calls = {};
  }
  // CGAL's engine is the reference, and stays it.
  const AlphaComplex reference = make_cgal_engine(balls_, {1, {}, maker("")})->compute({100}, {});
  EXPECT_TRUE(reference.engine.rests_on_cgal);
  EXPECT_EQ(calls.asked, 0);
}

TEST_F(ShortOfMemory, SaysWhyADeviceDoesNoMoreThanCompute) {
  UnionMeasures measures;
  const AlphaComplex complex = engine_->compute({100}, {});
  const auto why_not = [&] { return engine_->measure(complex, measures, {}).why_not; };
  EXPECT_EQ(engine_->measure(complex, measures, {}).device, "device");
  EXPECT_TRUE(engine_->find_outer_faces(complex));

  device_.full = true;
  EXPECT_EQ(why_not(), "the GPU's memory is full");
  EXPECT_FALSE(engine_->find_outer_faces(complex));
  device_.full = false;
  EXPECT_TRUE(engine_->find_outer_faces(complex)) << "the executor stays usable";
  EXPECT_EQ(device_.made, 1);

  device_.lost = true;
  EXPECT_EQ(why_not(), "the device is lost");
  device_.lost = false;
  EXPECT_FALSE(engine_->find_outer_faces(complex)) << "the complex went with the device";
  EXPECT_EQ(why_not(), "") << "it is sent to another";
  EXPECT_EQ(device_.made, 2);

  device_.room = 350;
  route(1e5);
  EXPECT_EQ(why_not(), "the GPU has no room for the whole complex");
}

TEST_F(ShortOfMemory, CancellingIsNeitherShortMemoryNorFailure) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(engine_->compute({100}, context), Cancelled);
  EXPECT_EQ(route(100), "device");
}

}  // namespace
}  // namespace alphascope
