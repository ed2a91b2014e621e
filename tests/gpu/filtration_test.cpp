// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a device makes the filtration, the incidences and the flow that the CPU makes.
#include "core/triangulation/filtration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/complex/alpha_complex.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"
#include "core/wrapping/seed.hpp"
#include "gpu/gpu_engine.hpp"
#include "gpu/wrapping/triangulator.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::balls_of_file;
using testing::NamedBalls;
using testing::Random;

// Bit by bit: a level that is never reached is NaN, and values may be -0.
bool same_bits(const ResultArray<float>& a, const ResultArray<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

class GpuFiltration : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!gpu_device().usable) GTEST_SKIP() << gpu_device().why_not;
    device_ = make_gpu_triangulator(seed_tetrahedron);
  }

  template <int N>
  void expect_list(const SimplexList<N>& found, const ClassLevels& levels,
                   const SimplexList<N>& expected, const ClassLevels& expected_levels) {
    if constexpr (N > 1) {
      EXPECT_TRUE(found.simplices == expected.simplices);
    }
    EXPECT_TRUE(same_bits(found.alpha_values, expected.alpha_values));
    EXPECT_TRUE(found.classes == expected.classes);
    EXPECT_TRUE(same_bits(levels.regular_from, expected_levels.regular_from));
    EXPECT_TRUE(same_bits(levels.interior_from, expected_levels.interior_from));
  }

  void expect_filtration(const BallSet& balls, const Triangulation& whole) {
    const Filtration expected(std::make_shared<const BallSet>(balls), whole);
    std::string why_not;
    const std::optional<FiltrationParts> made =
        device_->filtration_parts(balls, whole, {}, why_not);
    ASSERT_TRUE(made) << why_not;
    const AlphaComplex& top = expected.top();
    expect_list(made->vertices, made->levels.vertices, top.vertices, expected.levels().vertices);
    expect_list(made->edges, made->levels.edges, top.edges, expected.levels().edges);
    expect_list(made->triangles, made->levels.triangles, top.triangles,
                expected.levels().triangles);
    EXPECT_TRUE(same_bits(made->tetrahedron_values, top.tetrahedra.alpha_values));
    EXPECT_TRUE(made->hash_steps == expected.hash_steps());
  }
  void expect_ground(const BallSet& balls, const Triangulation& whole, FlowTies ties) {
    std::string why_not;
    const std::optional<TriangulationGround> made =
        device_->ground(balls, whole, ties, {}, why_not);
    ASSERT_TRUE(made) << why_not;
    EXPECT_TRUE(made->incidence == make_incidence(whole));
    const Flow expected = make_flow(balls, whole, ties);
    EXPECT_TRUE(made->flow.marks == expected.marks);
    EXPECT_TRUE(same_bits(made->flow.alpha_values, expected.alpha_values));
    EXPECT_EQ(made->flow.ties, expected.ties);
    ties_ += expected.ties;
    expect_memberships(balls, whole, *made);
  }
  // At alphas between values and at values, where integers decide.
  void expect_memberships(const BallSet& balls, const Triangulation& whole,
                          const TriangulationGround& ground) {
    const Flow& flow = ground.flow;
    std::vector<LatticeAlpha> alphas{-1e30, 0.0, 1e30};
    for (const std::size_t part : {8, 4, 2}) {
      const std::size_t t = flow.alpha_values.size() / part;
      const double value = static_cast<double>(flow.alpha_values[t]);
      if (std::isfinite(value)) alphas.insert(alphas.end(), {value, value / 2});
    }
    for (const LatticeAlpha& alpha : alphas) {
      const std::optional<Membership> in = device_->membership(ground.incidence, alpha, {});
      ASSERT_TRUE(in);
      const Membership expected = membership(balls, whole, ground.incidence, flow, alpha);
      EXPECT_TRUE(*in == expected);
      ties_at_alpha_ +=
          std::count(flow.alpha_values.begin(), flow.alpha_values.end(), alpha.nearest_float());
      in_part_ += expected.counts()[2] > 0 && expected.counts()[2] < expected.triangles.size();
    }
  }
  void expect_all(const BallSet& balls, const Triangulation& whole) {
    expect_filtration(balls, whole);
    expect_ground(balls, whole, FlowTies::perturbed);
    expect_ground(balls, whole, FlowTies::strict);
    hidden_ += whole.hidden.size();
  }
  // Of the CPU's triangulation, which is sent, and of the device's, which is there.
  void expect_cpu(const BallSet& balls) {
    const Triangulation whole = make_triangulation(balls, 1, {});
    if (whole.dimension < 3) return;
    expect_all(balls, whole);
    const DeviceTriangulation there = device_->make(balls, {});
    ASSERT_TRUE(there.triangulation) << there.report.why_not;
    expect_all(balls, *there.triangulation);
  }

  std::unique_ptr<DeviceTriangulator> device_;
  std::size_t hidden_ = 0, ties_ = 0, in_part_ = 0;
  std::ptrdiff_t ties_at_alpha_ = 0;
};

TEST_F(GpuFiltration, IsTheOneOfTheCpuForHardSets) {
  Random random(91);
  for (const NamedBalls& set : testing::large_hard_sets(random, 100)) {
    SCOPED_TRACE(set.name);
    expect_cpu(set.balls);
    if (HasFailure()) return;
  }
  EXPECT_GT(hidden_, 10u);
  EXPECT_GT(ties_, 100u);
  EXPECT_GT(ties_at_alpha_, 100);
  EXPECT_GT(in_part_, 100u);
}

TEST_F(GpuFiltration, IsTheOneOfTheCpuForSmallHardSets) {
  Random random(92);
  for (const NamedBalls& set : testing::small_hard_sets(random, 12)) {
    SCOPED_TRACE(set.name);
    expect_cpu(set.balls);
    if (HasFailure()) return;
  }
  EXPECT_GT(ties_, 10u);
}

TEST_F(GpuFiltration, IsTheOneOfTheCpuForAProtein) {
  const BallSet protein = balls_of_file("1crn.xyzr");
  for (const double solvent : {0.0, 1.4}) expect_cpu(with_solvent(protein, solvent));
}

// A large ball with all others around it: lists of its faces are long.
TEST_F(GpuFiltration, IsTheOneOfTheCpuForAHub) {
  Random random(93);
  BallSet balls = testing::random_balls(random, 300, 4000, 20, 200);
  testing::add_ball(balls, 0, 0, 0, 3000);
  expect_cpu(balls);
}

// Only the last triangulation is still on the device.
TEST_F(GpuFiltration, TellsTriangulationsApart) {
  Random random(94);
  const BallSet first = testing::random_balls(random, 150, 400, 20, 200),
                second = testing::random_balls(random, 150, 400, 20, 200);
  const DeviceTriangulation of_first = device_->make(first, {}),
                            of_second = device_->make(second, {});
  ASSERT_TRUE(of_first.triangulation && of_second.triangulation);
  expect_all(first, *of_first.triangulation);
  expect_all(second, *of_second.triangulation);
}

// Membership is of the last ground only.
TEST_F(GpuFiltration, KnowsItsLastGround) {
  Random random(95);
  const BallSet balls = testing::random_balls(random, 150, 400, 20, 200);
  const Triangulation whole = make_triangulation(balls, 1, {});
  std::string why_not;
  const auto first = device_->ground(balls, whole, FlowTies::perturbed, {}, why_not);
  ASSERT_TRUE(first && device_->membership(first->incidence, 0.0, {}));
  const TriangulationGround copy = *first;
  EXPECT_FALSE(device_->membership(copy.incidence, 0.0, {}));
  EXPECT_FALSE(device_->membership(make_incidence(whole), 0.0, {}));
  const auto second = device_->ground(balls, whole, FlowTies::perturbed, {}, why_not);
  EXPECT_FALSE(device_->membership(first->incidence, 0.0, {}));
  EXPECT_TRUE(device_->membership(second->incidence, 0.0, {}));
  EXPECT_TRUE(device_->filtration_parts(balls, whole, {}, why_not));
  EXPECT_FALSE(device_->membership(second->incidence, 0.0, {}));
  const auto third = device_->ground(balls, whole, FlowTies::perturbed, {}, why_not);
  EXPECT_TRUE(device_->make(balls, {}).triangulation);
  EXPECT_FALSE(device_->membership(third->incidence, 0.0, {}));
}

// Tables of cavities, of which the device makes all but the sums.
TEST_F(GpuFiltration, TablesHaveTheBitsOfTheCpu) {
  Random random(96);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 2300, 600, 20, 60));
  TriangulationMaker maker([](std::string&) { return make_gpu_triangulator(seed_tetrahedron); });
  const auto whole = std::make_shared<const Triangulation>(maker.make(*balls, 1, {}));
  ASSERT_TRUE(made_by_device(*whole));
  const auto table_by = [&](TriangulationMaker* by, double alpha, double solvent) {
    const auto ground = std::make_shared<const CavityGround>(
        make_cavity_ground(balls, whole, FlowTies::perturbed, {}, by));
    return make_cavity_table(ground, {Alpha{alpha}, solvent}, {}, by);
  };
  // With the largest solvent radius some balls are smaller than it.
  for (const double solvent : {0.0, 15.0, 40.0}) {
    const CavityTable found = table_by(&maker, 300, solvent),
                      expected = table_by(nullptr, 300, solvent);
    EXPECT_GT(expected.found.cavities.size(), 3u);
    EXPECT_TRUE(found.found == expected.found);
    EXPECT_EQ(found.order, expected.order);
    for (std::size_t c = 0; c < expected.measures.size(); ++c) {
      const CavityMeasures &a = found.measures[c], &b = expected.measures[c];
      EXPECT_EQ(a.volume_sa_angstrom3, b.volume_sa_angstrom3);
      EXPECT_EQ(a.area_sa_angstrom2, b.area_sa_angstrom2);
      EXPECT_EQ(a.volume_ms_angstrom3, b.volume_ms_angstrom3);
      EXPECT_EQ(a.area_ms_angstrom2, b.area_ms_angstrom2);
      EXPECT_EQ(a.area_ms_steiner_angstrom2, b.area_ms_steiner_angstrom2);
      EXPECT_EQ(a.volume_of_tetrahedra_angstrom3, b.volume_of_tetrahedra_angstrom3);
      EXPECT_EQ(a.arc_length_angstrom, b.arc_length_angstrom);
      EXPECT_EQ(a.corners, b.corners);
      EXPECT_EQ(a.lining, b.lining);
    }
  }
}

TEST_F(GpuFiltration, IsCancelled) {
  const BallSet balls = balls_of_file("1crn.xyzr");
  const Triangulation whole = make_triangulation(balls, 1, {});
  RunContext cancelled;
  cancelled.cancel.cancel();
  std::string why_not;
  EXPECT_THROW(device_->filtration_parts(balls, whole, cancelled, why_not), Cancelled);
  EXPECT_THROW(device_->ground(balls, whole, FlowTies::strict, cancelled, why_not), Cancelled);
  expect_all(balls, whole);
}

}  // namespace
}  // namespace alphascope
