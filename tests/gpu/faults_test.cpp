// SPDX-License-Identifier: GPL-3.0-or-later
// Tests an emulated device that is full or lost at any moment. The answer must be the same and name
// its origin, and the engine must work as before afterwards. Also tests messages for impossible
// results of the device.
#include <gtest/gtest.h>

#include <ostream>

#include "core/run/internal_error.hpp"
#include "gpu/dual_edge/gather_kernels.cuh"
#include "gpu/dual_edge/pipeline_state.cuh"
#include "gpu/gpu_engine.hpp"
#include "tests/gpu/emulated/device.h"
#include "tests/support/device_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

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
    ASSERT_TRUE(gpu_device().usable) << gpu_device().why_not;
    testing::Random random(31);
    balls_ = std::make_shared<const BallSet>(testing::large_hard_sets(random).front().balls);
  }
  void TearDown() override { emulated::be_sound(); }
  std::unique_ptr<Engine> make() const {
    return testing::make_gpu_engine(balls_, {}, nullptr, {GetParam().chunks});
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
    const auto engine = make();
    ASSERT_TRUE(engine);
    emulated::be_full_at(n);
    const AlphaComplex found = engine->compute(request(), {});
    const bool met = emulated::faults_met() > 0;
    emulated::be_sound();
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
  const auto engine = make();
  ASSERT_TRUE(engine);
  emulated::be_full_at(3);
  EXPECT_TRUE(in_slabs(engine->compute(request(), {})));
  emulated::be_sound();
  EXPECT_TRUE(in_slabs(engine->compute(request(), {}))) << "nothing says that there is room now";
  const AlphaRequest smaller{0.25, GetParam().tetrahedra_only};
  const AlphaComplex found = engine->compute(smaller, {});
  EXPECT_FALSE(in_slabs(found)) << found.engine.route;
  EXPECT_EQ(found.hash, cpu->compute(smaller, {}).hash);
}

// The memory may have been used by another program for a while. So the engine tries with fewer
// slabs again from time to time.
TEST_P(GpuFaults, FewerSlabsAreTriedOnceInAWhile) {
  const auto engine = make();
  ASSERT_TRUE(engine);
  const std::uint64_t expected = expected_hash();
  emulated::be_full_at(3);
  int in_slabs = 0;
  for (int answer = 0; answer < 12; ++answer) {
    const AlphaComplex found = engine->compute(request(), {});
    emulated::be_sound();
    EXPECT_EQ(found.hash, expected) << answer;
    in_slabs += found.engine.route.find("slabs") != std::string::npos;
  }
  EXPECT_EQ(in_slabs, 8);
}

TEST_P(GpuFaults, ALostDeviceIsAnsweredByTheCpu) {
  const std::uint64_t expected = expected_hash();
  int lost = 0;
  for (int n = 0;; ++n) {
    const auto engine = make();
    ASSERT_TRUE(engine);
    emulated::be_lost_at(n);
    const AlphaComplex found = engine->compute(request(), {});
    const bool met = emulated::faults_met() > 0;
    emulated::be_sound();
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

// Every triangle of a complex has its edges among those that the device found. No set of balls
// violates this. If one is missing, the engine says so, and returns no complex without it.
TEST_P(GpuFaults, AMissingEdgeIsSaid) {
  const auto engine = make();
  ASSERT_TRUE(engine);
  const std::uint64_t expected = expected_hash();
  int changed = 0;
  emulated::change_copies_to_host([&](void* data, std::size_t bytes) {
    if (bytes != sizeof(gpu::Counters)) return;
    static_cast<gpu::Counters*>(data)->missing_edges = 2;
    ++changed;
  });
  try {
    engine->compute(request(), {});
    ADD_FAILURE() << "nothing was said";
  } catch (const InternalError& error) {
    EXPECT_NE(std::string(error.what()).find("found 2 triangles of the complex without one of"),
              std::string::npos)
        << error.what();
  }
  EXPECT_GT(changed, 0);
  emulated::be_sound();
  EXPECT_EQ(engine->compute(request(), {}).hash, expected) << "afterwards";
}

// Tests the search that counts missing edges.
TEST(GpuFindEdge, CountsWhatIsNotThere) {
  std::uint32_t end[] = {9, 9, 3, 5, 8, 9}, start[] = {0, 2, 0}, count[] = {0, 3, 0}, missing = 0;
  gpu::EdgeCandidates edges{};
  edges.end = end;
  edges.start = start;
  edges.count = count;
  edges.missing = &missing;
  EXPECT_EQ(gpu::find_edge(edges, 1, 3), 2u);
  EXPECT_EQ(gpu::find_edge(edges, 1, 5), 3u);
  EXPECT_EQ(gpu::find_edge(edges, 1, 8), 4u);
  EXPECT_EQ(missing, 0u);
  std::uint32_t in_vain = 0;
  for (const std::uint32_t k : {2u, 4u, 6u, 9u}) {
    EXPECT_EQ(gpu::find_edge(edges, 1, k), gpu::kNoEdge) << k;
    EXPECT_EQ(missing, ++in_vain);
  }
  EXPECT_EQ(gpu::find_edge(edges, 0, 9), gpu::kNoEdge) << "ball 0 has no edges";
  EXPECT_EQ(missing, ++in_vain);
}

}  // namespace
}  // namespace alphascope
