// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the tuple engine on an emulated device that is full or lost at any moment. It reports the
// fault, and computes again once there is room or the device is back.
#include <gtest/gtest.h>

#include <ostream>

#include "core/engine/engine.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/tuples/tuple_engine.hpp"
#include "tests/gpu/emulated/device.h"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

struct Switches {
  const char* name;
  TupleOptions options;
};
void PrintTo(const Switches& switches, std::ostream* out) {
  *out << switches.name;
}

class GpuTupleFaults : public ::testing::TestWithParam<Switches> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(gpu_device().usable) << gpu_device().why_not;
    testing::Random random(45);
    balls_ = std::make_shared<const BallSet>(testing::random_balls(random, 24, 1000, 100, 300));
    expected_ = make_cpu_engine(balls_)->compute(kLater, {}).hash;
  }
  void TearDown() override { emulated::be_sound(); }

  std::unique_ptr<Engine> make(std::string* why_not = nullptr) const {
    return make_gpu_tuple_engine(balls_, GetParam().options, why_not);
  }

  // At the first alpha half of the balls are empty. The second one needs more of everything.
  static inline const AlphaRequest kFirst{-40000}, kLater{100000};
  std::shared_ptr<const BallSet> balls_;
  std::uint64_t expected_ = 0;
};
INSTANTIATE_TEST_SUITE_P(
    Switches, GpuTupleFaults,
    ::testing::Values(Switches{"AllOn", {}},
                      Switches{"Batches", {.streams = 3, .tuples_per_batch = 90}},
                      Switches{"AllOff",
                               {TupleGridKind::automatic, false, false, false, 1, false}}),
    [](const auto& given) { return given.param.name; });

TEST_P(GpuTupleFaults, ARefusedReservationIsSaid) {
  int refused = 0;
  for (int n = 0;; ++n) {
    const auto dropped = make(), kept = make();
    ASSERT_TRUE(dropped && kept);
    bool met = false;
    for (const auto* engine : {&dropped, &kept}) {
      emulated::be_full_at(n);
      try {
        (*engine)->compute(kFirst, {});
        EXPECT_EQ(emulated::faults_met(), 0) << "nothing was said of reservation " << n;
      } catch (const std::bad_alloc&) {
        EXPECT_GT(emulated::faults_met(), 0);
      }
      met = emulated::faults_met() > 0;
      emulated::be_sound();
    }
    EXPECT_EQ(kept->compute(kLater, {}).hash, expected_) << "after reservation " << n;
    if (!met) break;
    ++refused;
  }
  EXPECT_GT(refused, 20);
}

TEST_P(GpuTupleFaults, ALostDeviceIsSaid) {
  int lost = 0;
  for (int n = 0;; ++n) {
    emulated::be_lost_at(n);
    std::string why_not;
    const auto engine = make(&why_not);
    EXPECT_EQ(engine == nullptr, emulated::faults_met() > 0) << "call " << n;
    if (engine) {
      try {
        engine->compute(kFirst, {});
        EXPECT_EQ(emulated::faults_met(), 0) << "nothing was said of call " << n;
      } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("the GPU failed while"), std::string::npos)
            << error.what();
      }
    } else {
      EXPECT_NE(why_not.find("cannot be used"), std::string::npos) << why_not;
    }
    const bool met = emulated::faults_met() > 0;
    emulated::be_sound();
    if (engine) {
      EXPECT_EQ(engine->compute(kLater, {}).hash, expected_) << "after call " << n;
    }
    if (!met) break;
    ++lost;
  }
  EXPECT_GT(lost, 50);
}

}  // namespace
}  // namespace alphascope
