// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the limit of device memory: it is never exceeded, and results stay the same.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "core/engine/engine.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/memory/device_memory.hpp"
#include "gpu/wrapping/triangulator.hpp"
#include "tests/support/device_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using gpu::DeviceMemory;
using testing::Random;

class GpuMemoryLimit : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
    DeviceMemory::set_limit(0);
  }
  void TearDown() override {
    DeviceMemory::set_limit(0);
    unsetenv("ALPHASCOPE_GPU_MEMORY");
  }
  // The most bytes that `use` held beyond those held before it.
  template <class Use>
  static std::size_t most_of(const Use& use) {
    const std::size_t before = DeviceMemory::held();
    DeviceMemory::forget_most();
    use();
    return DeviceMemory::most_held() - before;
  }
  // Allows so many bytes beyond those that are held.
  static void allow(std::size_t bytes) { DeviceMemory::set_limit(DeviceMemory::held() + bytes); }
};

TEST_F(GpuMemoryLimit, OfATriangulation) {
  Random random(51);
  const BallSet balls = testing::random_balls(random, 400, 300, 20, 60);
  const Triangulation expected = make_cgal_triangulation(balls, 1);
  const auto make = [&](DeviceTriangulation& made) {
    return most_of([&] { made = make_gpu_triangulator(seed_tetrahedron)->make(balls, {}); });
  };
  DeviceTriangulation made;
  const std::size_t most = make(made);
  ASSERT_TRUE(made.triangulation && *made.triangulation == expected) << made.report.why_not;
  EXPECT_GT(most, 0u);
  EXPECT_EQ(most_of([] {}), 0u) << "all is given back";
  allow(most / 2);
  EXPECT_LE(make(made), most / 2);
  EXPECT_FALSE(made.triangulation);
  EXPECT_NE(made.report.why_not.find("too little memory"), std::string::npos)
      << made.report.why_not;
  allow(most);
  EXPECT_LE(make(made), most);
  EXPECT_TRUE(made.triangulation && *made.triangulation == expected) << made.report.why_not;
}

TEST_F(GpuMemoryLimit, OfAnEngineMakesItComputeInSlabs) {
  Random random(52);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 3000, 1000, 20, 60));
  const AlphaRequest request{400, false};
  const std::uint64_t expected = make_cpu_engine(balls)->compute(request, {}).hash;
  AlphaComplex found;
  const auto compute = [&] {
    return most_of([&] {
      found = testing::make_gpu_engine(balls, {}, nullptr, {1})->compute(request, {});
      EXPECT_EQ(found.hash, expected) << found.engine.route;
    });
  };
  const std::size_t most = compute();
  EXPECT_EQ(found.engine.route.find("slabs"), std::string::npos) << found.engine.route;
  allow(2 * most / 3);
  EXPECT_LE(compute(), 2 * most / 3);
  EXPECT_NE(found.engine.route.find("slabs"), std::string::npos) << found.engine.route;
}

TEST_F(GpuMemoryLimit, IsReadFromTheEnvironment) {
  const auto read = [](const char* value) {
    setenv("ALPHASCOPE_GPU_MEMORY", value, 1);
    return DeviceMemory::read_limit();
  };
  for (const char* wrong : {"8 GB", "-1", "0", "1.5", "99999999999999999999"})
    EXPECT_NE(read(wrong).find(wrong), std::string::npos) << wrong;
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(DeviceMemory::limit(), 0u);
  EXPECT_EQ(read("8000"), "");
  EXPECT_EQ(DeviceMemory::limit(), 8'000'000'000u);
}

}  // namespace
}  // namespace alphascope
