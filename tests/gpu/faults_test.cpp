// A device that is full or lost at any moment: the answer is the same, it is said where it came
// from, and the engine is as good as new afterwards.
#include "gpu/memory/faults.hpp"

#include <gtest/gtest.h>

#include <ostream>

#include "gpu/dual_edge/dual_edge_pipeline.hpp"
#include "gpu/gpu_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using gpu::Faults;

struct Given {
  const char* name;
  bool tetrahedra_only;
  int chunks;
};
void PrintTo(const Given& given, std::ostream* out) {
  *out << given.name;
}

class GpuFaults : public ::testing::TestWithParam<Given> {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
    gpu::DualEdgePipeline::forced_chunks = GetParam().chunks;
    testing::Random random(31);
    balls_ = std::make_shared<const BallSet>(testing::large_hard_sets(random).front().balls);
  }
  void TearDown() override {
    Faults::none();
    gpu::DualEdgePipeline::forced_chunks = 0;
  }

  AlphaRequest request() const { return {0.5, GetParam().tetrahedra_only}; }
  std::uint64_t expected_hash() const {
    return make_cpu_engine(balls_)->compute(request(), {}).hash;
  }
  static bool on_cpu(const AlphaComplex& complex) {
    return complex.engine.route.find("on the CPU") != std::string::npos;
  }

  std::shared_ptr<const BallSet> balls_;
};
INSTANTIATE_TEST_SUITE_P(Requests, GpuFaults,
                         ::testing::Values(Given{"TetrahedraOnly", true, 1},
                                           Given{"Whole", false, 1},
                                           Given{"WholeInChunks", false, 3}),
                         [](const auto& given) { return given.param.name; });

TEST_P(GpuFaults, ARefusedReservationIsAnsweredInSlabs) {
  const std::uint64_t expected = expected_hash();
  int refused = 0;
  for (int n = 0;; ++n) {
    const auto engine = make_gpu_engine(balls_, {}, nullptr);
    ASSERT_TRUE(engine);
    Faults::none();
    Faults::refuse_reservation = n;
    const AlphaComplex found = engine->compute(request(), {});
    const bool met = Faults::met > 0;
    Faults::none();
    EXPECT_EQ(found.hash, expected) << "reservation " << n << ", " << found.engine.route;
    if (!met) break;
    ++refused;
    EXPECT_NE(found.engine.route.find("slabs"), std::string::npos) << found.engine.route;
    EXPECT_EQ(engine->compute(request(), {}).hash, expected) << "after reservation " << n;
  }
  EXPECT_GT(refused, 10);
}

TEST_P(GpuFaults, ASmallerRequestReturnsToFewerSlabs) {
  const auto in_slabs = [](const AlphaComplex& complex) {
    return complex.engine.route.find("slabs") != std::string::npos;
  };
  const auto cpu = make_cpu_engine(balls_);
  const auto engine = make_gpu_engine(balls_, {}, nullptr);
  ASSERT_TRUE(engine);
  Faults::none();
  Faults::refuse_reservation = 3;
  EXPECT_TRUE(in_slabs(engine->compute(request(), {})));
  Faults::none();
  EXPECT_TRUE(in_slabs(engine->compute(request(), {}))) << "nothing says that there is room now";
  const AlphaRequest smaller{0.25, GetParam().tetrahedra_only};
  const AlphaComplex found = engine->compute(smaller, {});
  EXPECT_FALSE(in_slabs(found)) << found.engine.route;
  EXPECT_EQ(found.hash, cpu->compute(smaller, {}).hash);
}

// Others may have had the device's memory.
TEST_P(GpuFaults, FewerSlabsAreTriedOnceInAWhile) {
  const auto engine = make_gpu_engine(balls_, {}, nullptr);
  ASSERT_TRUE(engine);
  const std::uint64_t expected = expected_hash();
  Faults::none();
  Faults::refuse_reservation = 3;
  int in_slabs = 0;
  for (int answer = 0; answer < 12; ++answer) {
    const AlphaComplex found = engine->compute(request(), {});
    Faults::none();
    EXPECT_EQ(found.hash, expected) << answer;
    in_slabs += found.engine.route.find("slabs") != std::string::npos;
  }
  EXPECT_EQ(in_slabs, 8);
}

TEST_P(GpuFaults, ALostDeviceIsAnsweredByTheCpu) {
  const std::uint64_t expected = expected_hash();
  int lost = 0;
  for (int n = 0;; ++n) {
    const auto engine = make_gpu_engine(balls_, {}, nullptr);
    ASSERT_TRUE(engine);
    Faults::none();
    Faults::lose_device = n;
    const AlphaComplex found = engine->compute(request(), {});
    const bool met = Faults::met > 0;
    Faults::none();
    EXPECT_EQ(found.hash, expected) << "call " << n;
    if (!met) break;
    ++lost;
    EXPECT_TRUE(on_cpu(found)) << "call " << n << ", " << found.engine.route;
    const AlphaComplex again = engine->compute(request(), {});
    EXPECT_EQ(again.hash, expected);
    EXPECT_FALSE(on_cpu(again)) << again.engine.route;
  }
  EXPECT_GT(lost, 10);
}

}  // namespace
}  // namespace alphascope
