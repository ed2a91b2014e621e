// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what CPU engines report beside the complex: lattice, device, times and route.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/engine/engine.hpp"
#include "core/engines/route.hpp"
#include "core/geometry/alpha.hpp"
#include "core/neighbours/uniform_grid.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

std::shared_ptr<const BallSet> some_balls(int digits = 3) {
  Random random(51);
  BallSet balls = testing::random_balls(random, 300, 1000, 50, 100);
  balls.lattice.digits = digits;
  return std::make_shared<const BallSet>(std::move(balls));
}

std::vector<std::string> labels(const StageTimes& times, bool setup) {
  std::vector<std::string> result;
  for (const StageTime& stage : times.stages) {
    if (stage.setup == setup) result.push_back(stage.label);
  }
  return result;
}

using Labels = std::vector<std::string>;
const std::string kCoincident(stage::kCoincident), kGrid(stage::kGrid),
    kClassification(stage::kClassification), kThreshold(stage::kThreshold);

TEST(CpuEngine, SaysWhatItsAnswerIsOf) {
  for (const int digits : {3, 5}) {
    const auto balls = some_balls(digits);
    for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
      const auto engine = make(balls, {1});
      const double alpha = 100 * balls->lattice.square_angstrom(1);
      for (const bool tetrahedra_only : {true, false}) {
        const AlphaComplex complex = engine->compute({alpha, tetrahedra_only}, {});
        EXPECT_EQ(complex.lattice.digits, digits);
        EXPECT_DOUBLE_EQ(complex.alpha_angstrom2().nearest(), alpha);
        EXPECT_EQ(complex.tetrahedra_only, tetrahedra_only);
        EXPECT_EQ(complex.engine.device, "CPU, 1 thread");
        double sum = 0;
        for (const StageTime& stage : complex.timings.stages) sum += stage.milliseconds;
        EXPECT_GT(sum, 0);
        EXPECT_GE(complex.timings.wall_milliseconds, sum * (1 - 1e-9));
      }
    }
  }
}

// The first whole complex, then two smaller ones. Each stage is named, and work done once is
// setup.
TEST(CpuEngine, NamesItsStages) {
  const auto engine = testing::keeping(make_cpu_engine(some_balls(), {1}));
  const AlphaComplex first = engine->compute({100e-6}, {});
  EXPECT_EQ(labels(first.timings, true), (Labels{kCoincident}));
  EXPECT_EQ(labels(first.timings, false),
            (Labels{kGrid, std::string(stage::kCandidates), std::string(stage::kFilteredValidity),
                    std::string(stage::kExactValidity), std::string(stage::kPrefixSum),
                    std::string(stage::kHash)}));
  const AlphaComplex below = engine->compute({90e-6}, {});
  EXPECT_EQ(labels(below.timings, true), (Labels{kClassification}));
  EXPECT_EQ(labels(below.timings, false), (Labels{kThreshold}));
  const AlphaComplex again = engine->compute({80e-6}, {});
  EXPECT_EQ(labels(again.timings, true), Labels{});
  EXPECT_EQ(labels(again.timings, false), (Labels{kThreshold}));
}

// The time of a stage is a difference of two measured times, and must not be negative. Floating
// point and integers are measured together.
TEST(CpuEngine, NoStageTakesLessThanNoTime) {
  Random random(52);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 12, 1000, 300, 500));
  for (int round = 0; round < 20; ++round) {
    const AlphaComplex complex = make_cpu_engine(balls, {1})->compute({0.1}, {});
    ASSERT_EQ(complex.engine.route, kClippingRoute);
    for (const StageTime& stage : complex.timings.stages) {
      EXPECT_GE(stage.milliseconds, 0) << stage.label;
    }
  }
}

// If the owner of a triangulation has dropped it, the engine clips again instead of triangulating.
TEST(CpuEngine, ClipsAgainWhenItsTriangulationIsGone) {
  const auto engine = make_cpu_engine(some_balls(), {1});
  KnownResults known;
  engine->compute({1e300}, known, {});
  EXPECT_TRUE(known.filtration);
  EXPECT_EQ(engine->compute({100e-6}, known, {}).engine.route, kThresholdRoute);
  known = {};
  EXPECT_EQ(engine->compute({100e-6}, known, {}).engine.route, kClippingRoute);
}

// 27 touching balls of a cubic lattice. The middle one meets six, and 54 pairs meet.
TEST(Route, ATriangulationThatIsThereIsUsedForTetrahedra) {
  BallSet balls;
  for (int i = 0; i < 27; ++i) {
    balls.centres.push_back({1000 * (i % 3), 1000 * (i / 3 % 3), 1000 * (i / 9)});
    balls.radii.push_back(510);
  }
  const UniformGrid grid = make_uniform_grid(balls, balls.lattice.alpha_on_lattice(0), {});
  // With four neighbours each, clipping takes 0.1 + 0.085 · 4 + 0.0034 · 16.7 = 0.5 µs a ball.
  // Ortho-radii of tetrahedra take 0.2 µs, a triangulation 3.5 µs.
  EXPECT_EQ(choose_route(grid, {1, true, true}), Route::triangulate);
  EXPECT_EQ(choose_route(grid, {1, true, false}), Route::clip_dual_edges);
  EXPECT_EQ(choose_route(grid, {1, false, true}), Route::clip_dual_edges);
  EXPECT_EQ(choose_route(grid, {1, false, false}), Route::clip_dual_edges);
}

}  // namespace
}  // namespace alphascope
