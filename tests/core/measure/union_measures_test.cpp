// SPDX-License-Identifier: GPL-3.0-or-later
// Tests areas and volumes of unions of balls.
#include "core/measure/union_measures.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/geometry/lattice_point.hpp"
#include "core/measure/ball_geometry.hpp"
#include "tests/core/measure/measured_sets.hpp"
#include "tests/support/engines.hpp"

namespace alphascope {
namespace {

using testing::add_ball;
using testing::balls_of_file;
using testing::complex_of;
using testing::measured;
using testing::Random;
using testing::random_balls;

BallSet angstrom_balls(std::initializer_list<std::array<int, 4>> rows) {
  BallSet balls;
  balls.lattice.digits = 0;
  for (const auto& row : rows) add_ball(balls, row[0], row[1], row[2], row[3]);
  return balls;
}

TEST(UnionMeasures, OfNoBallAreNothing) {
  const UnionMeasures none = measured(BallSet{});
  EXPECT_EQ(none.area_angstrom2(), 0);
  EXPECT_EQ(none.volume_angstrom3(), 0);
  EXPECT_TRUE(none.ball_area_angstrom2().empty());
}

TEST(UnionMeasures, OfOneBallAreItsOwnAtEveryAlpha) {
  const BallSet one = angstrom_balls({{1, 2, 3, 2}});
  for (const double alpha : {-3.0, 0.0, 5.0}) {
    const UnionMeasures of = measured(one, alpha);
    EXPECT_DOUBLE_EQ(of.area_angstrom2(), sphere_area(std::sqrt(4 + alpha)));
    EXPECT_DOUBLE_EQ(of.volume_angstrom3(), ball_volume(std::sqrt(4 + alpha)));
  }
  EXPECT_EQ(measured(one, -4).area_angstrom2(), 0);
  EXPECT_EQ(measured(one, -5).volume_angstrom3(), 0);
}

TEST(UnionMeasures, OfHiddenAndEqualBallsAreZero) {
  const UnionMeasures of =
      measured(angstrom_balls({{0, 0, 0, 3}, {0, 0, 1, 1}, {0, 0, 0, 3}, {0, 0, 0, 2}}));
  EXPECT_DOUBLE_EQ(of.ball_area_angstrom2()[0], sphere_area(3));
  EXPECT_DOUBLE_EQ(of.ball_volume_angstrom3()[0], ball_volume(3));
  for (const std::size_t i : {1, 2, 3}) {
    EXPECT_EQ(of.ball_area_angstrom2()[i], 0);
    EXPECT_EQ(of.ball_volume_angstrom3()[i], 0);
  }
}

// Degenerate sets of an independent program, compared to all its digits.
TEST(UnionMeasures, OfTrapsAreThoseOfAnotherProgram) {
  std::ifstream table(testing::measure_data("traps.tsv"));
  std::string name, area, volume;
  table >> name >> area >> volume;
  int sets = 0;
  while (table >> name >> area >> volume) {
    const UnionMeasures of = measured(balls_of_file(name + ".xyzr"));
    EXPECT_NEAR(of.area_angstrom2(), std::stod(area), 1e-11) << name;
    EXPECT_NEAR(of.volume_angstrom3(), std::stod(volume), 1e-11) << name;
    ++sets;
  }
  EXPECT_EQ(sets, 15);
}

TEST(UnionMeasures, OfEachBallOfAProteinAreThoseOfAnotherProgram) {
  const BallSet balls = with_solvent(balls_of_file("1crn.xyzr"), 1.4);
  const UnionMeasures of = measured(balls);
  std::ifstream table(testing::measure_data("1crn_s1.4.tsv"));
  std::string head;
  std::getline(table, head);
  std::size_t i = 0, rows = 0;
  double area = 0, volume = 0;
  for (; table >> i >> area >> volume; ++rows) {
    EXPECT_NEAR(of.ball_area_angstrom2()[i], area, 1e-11) << i;
    EXPECT_NEAR(of.ball_volume_angstrom3()[i], volume, 1e-11) << i;
    EXPECT_EQ(of.ball_area_angstrom2()[i] == 0, area == 0) << i;
  }
  EXPECT_EQ(rows, 327u);
  EXPECT_NEAR(of.area_angstrom2(), 2971.32301600, 6e-9);
  EXPECT_NEAR(of.volume_angstrom3(), 8357.32154551, 6e-9);
}

// Samples points of a spiral on each sphere, and of a grid over the union.
TEST(UnionMeasures, AgreeWithSampling) {
  Random random(7);
  for (int n = 0; n < 3; ++n) {
    const BallSet balls = random_balls(random, 40, 900, 100, 400);
    const double alpha = 1e-6 * (n - 1) * 5000;
    BallSet fine = balls;
    fine.lattice.digits = 3;
    const UnionMeasures of = measured(fine, alpha);
    const double alpha_units = alpha * 1e6;
    const auto covered = [&](double x, double y, double z, std::size_t but) {
      for (std::size_t j = 0; j < fine.size(); ++j) {
        const LatticePoint& c = fine.centres[j];
        const double r2 = static_cast<double>(fine.weight(static_cast<BallIndex>(j))) + alpha_units;
        if (j != but &&
            (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) + (z - c.z) * (z - c.z) < r2) {
          return true;
        }
      }
      return false;
    };
    constexpr int kPoints = 4000;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const double r2 = static_cast<double>(fine.weight(static_cast<BallIndex>(i))) + alpha_units;
      const double r = std::sqrt(std::max(0.0, r2));
      int free = 0;
      for (int p = 0; p < kPoints; ++p) {
        const double z = 1 - (2 * p + 1.0) / kPoints, turn = 2.399963229728653 * p;
        const double across = std::sqrt(1 - z * z);
        const LatticePoint& c = fine.centres[i];
        free += !covered(c.x + r * across * std::cos(turn), c.y + r * across * std::sin(turn),
                         c.z + r * z, i);
      }
      EXPECT_NEAR(of.ball_area_angstrom2()[i], 1e-6 * sphere_area(r) * free / kPoints,
                  1e-6 * sphere_area(r) * 0.01)
          << i;
    }
    std::size_t inside = 0;
    constexpr int kStep = 26;
    for (int x = -1300; x <= 1300; x += kStep) {
      for (int y = -1300; y <= 1300; y += kStep) {
        for (int z = -1300; z <= 1300; z += kStep) inside += covered(x, y, z, fine.size());
      }
    }
    const double sampled = 1e-9 * kStep * kStep * kStep * static_cast<double>(inside);
    EXPECT_NEAR(of.volume_angstrom3(), sampled, 0.003 * sampled);
  }
}

TEST(UnionMeasures, AreTheSameBitsForAllThreadsAndEngines) {
  const BallSet balls = with_solvent(balls_of_file("1crn.xyzr"), 1.4);
  const UnionMeasures first = measured(balls);
  UnionDerivatives derivatives;
  measured(balls, 0, {1, &derivatives});
  for (const testing::EngineFactory& factory : testing::engines()) {
    if (!factory.affords(balls, 0)) continue;
    const AlphaComplex complex = factory.make(std::make_shared<BallSet>(balls))->compute({}, {});
    for (const int threads : {1, 2, 5}) {
      UnionDerivatives again;
      const UnionMeasures of = measure_union(balls, complex, {threads, &again});
      EXPECT_EQ(of.total, first.total) << factory.name;
      EXPECT_EQ(of.of_ball, first.of_ball) << factory.name;
      EXPECT_EQ(again.area_by_radius_angstrom, derivatives.area_by_radius_angstrom);
    }
  }
}

// The union does not depend on the order of its balls, and equal balls may swap places.
TEST(UnionMeasures, DoNotDependOnTheOrderOfBalls) {
  Random random(8);
  for (auto& [name, balls, unit] : testing::large_hard_sets(random, 300)) {
    std::vector<BallIndex> order(balls.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    for (const double alpha : {0.0, 2.0}) {
      const UnionMeasures a = measured(balls, alpha * unit),
                          b = measured(testing::permuted(balls, order), alpha * unit);
      const double area = std::max(1e-300, a.area_angstrom2()), volume = a.volume_angstrom3();
      // Caps of a ball that small ones cut at its rim are flat. Their rounding errors add up to
      // 1.4e-11 (60 seeds). Elsewhere errors stay below 1e-12.
      const double near = name.starts_with("at a rim") ? 5e-11 : 1e-12;
      EXPECT_NEAR(a.area_angstrom2(), b.area_angstrom2(), near * area) << name;
      EXPECT_NEAR(a.volume_angstrom3(), b.volume_angstrom3(), near * volume) << name;
    }
  }
}

// Balls that touch a large one from inside add nothing to the union.
TEST(UnionMeasures, OfBallsThatTouchFromInsideAreThoseOfTheLargeOne) {
  const BallSet balls = angstrom_balls({{0, 0, 0, 50},
                                        {15, 20, 0, 25},
                                        {0, 15, 20, 25},
                                        {20, 0, -15, 25},
                                        {-24, 32, 0, 10},
                                        {9, 0, 12, 35},
                                        {0, -12, -9, 35}});
  const UnionMeasures of = measured(balls);
  EXPECT_NEAR(of.area_angstrom2(), sphere_area(50), 1e-14 * sphere_area(50));
  EXPECT_NEAR(of.volume_angstrom3(), ball_volume(50), 1e-14 * ball_volume(50));
  Random random(10);
  for (int n = 0; n < 100; ++n) {
    for (const int factor : {1, 10000}) {
      const BallSet set = testing::balls_through_a_point(random, 9, factor);
      std::vector<BallIndex> order = {4, 8, 2, 7, 5, 0, 1, 6, 3};
      const UnionMeasures a = measured(set), b = measured(testing::permuted(set, order));
      EXPECT_NEAR(a.area_angstrom2(), b.area_angstrom2(), 1e-13 * a.area_angstrom2()) << n;
      EXPECT_NEAR(a.volume_angstrom3(), b.volume_angstrom3(), 1e-13 * a.volume_angstrom3()) << n;
    }
  }
}

// No ball has more than its whole sphere and ball, or less than zero. The surface of the union
// obeys the isoperimetric inequality.
TEST(UnionMeasures, StayWithinBoundsOnHardSets) {
  Random random(9);
  auto sets = testing::small_hard_sets(random, 40);
  for (auto& set : testing::large_hard_sets(random, 200)) sets.push_back(std::move(set));
  for (const auto& [name, balls, unit] : sets) {
    for (const double alpha : {-0.5, 0.0, 1.0, 30.0}) {
      const UnionMeasures of = measured(balls, alpha * unit);
      const double grown = balls.lattice.alpha_on_lattice(alpha * unit).nearest();
      for (std::size_t i = 0; i < balls.size(); ++i) {
        const double square =
            std::max(0.0, static_cast<double>(balls.weight(static_cast<BallIndex>(i))) + grown);
        const double r = balls.lattice.angstrom(std::sqrt(square));
        EXPECT_GE(of.ball_area_angstrom2()[i], 0);
        EXPECT_LE(of.ball_area_angstrom2()[i], sphere_area(r) * (1 + 1e-13)) << name << i;
        EXPECT_GE(of.ball_volume_angstrom3()[i], 0);
        EXPECT_LE(of.ball_volume_angstrom3()[i], ball_volume(r) * (1 + 1e-13)) << name << i;
      }
      const double least = std::cbrt(36 * kPi * of.volume_angstrom3() * of.volume_angstrom3());
      EXPECT_GE(of.area_angstrom2() * (1 + 1e-12), least) << name;
    }
  }
}

TEST(UnionMeasures, RefuseWhatTheyCannotMeasure) {
  const BallSet balls = angstrom_balls({{0, 0, 0, 2}, {3, 0, 0, 2}});
  const AlphaComplex complex = complex_of(balls);
  EXPECT_THROW(measure_union(angstrom_balls({{0, 0, 0, 2}}), complex), std::invalid_argument);
  AlphaComplex half = complex;
  half.tetrahedra_only = true;
  EXPECT_THROW(measure_union(balls, half), std::invalid_argument);
  RunContext cancelled;
  cancelled.cancel.cancel();
  EXPECT_THROW(measure_union(balls, complex, {}, cancelled), Cancelled);
}

TEST(Components, AreNumberedByTheirLowestBalls) {
  const BallSet balls = angstrom_balls(
      {{90, 0, 0, 2}, {0, 0, 0, 2}, {3, 0, 0, 2}, {0, 0, 0, 1}, {93, 0, 0, 2}, {50, 0, 0, 1}});
  const AlphaComplex complex = complex_of(balls);
  const Components of = components(balls.size(), complex);
  EXPECT_EQ(of.count, 3u);
  EXPECT_EQ(of.of_ball, (std::vector<std::uint32_t>{0, 1, 1, kNoGroup, 0, 2}));
  const UnionMeasures measures = measure_union(balls, complex);
  const auto areas = sums_by_group(measures.ball_area_angstrom2(), of.of_ball, of.count);
  EXPECT_DOUBLE_EQ(areas[0], 28 * kPi);
  EXPECT_DOUBLE_EQ(areas[1], 28 * kPi);
  EXPECT_DOUBLE_EQ(areas[2], 4 * kPi);
}

TEST(SumsByGroup, LoseNothingAndRefuseWrongGroups) {
  EXPECT_EQ(sums_by_group(std::vector<double>{1, 1e100, 1, -1e100, 7},
                          std::vector<std::uint32_t>{0, 0, 0, 0, kNoGroup}, 2),
            (std::vector<double>{2, 0}));
  const std::vector<double> one = {1};
  EXPECT_THROW(sums_by_group(one, std::vector<std::uint32_t>{2}, 2), std::invalid_argument);
  EXPECT_THROW(sums_by_group(one, std::vector<std::uint32_t>{}, 2), std::invalid_argument);
}

// Shares of a sphere with squared radius r² + alpha. A sphere shrunk away by alpha has none.
TEST(FreeAreas, AreThoseOfTheGrownBalls) {
  BallSet balls;
  testing::add_ball(balls, 0, 0, 0, 1000);
  testing::add_ball(balls, 500, 0, 0, 2000);
  constexpr double kPi = 3.14159265358979323846;
  const auto grown = free_areas_angstrom2(balls, balls.lattice.alpha_on_lattice(1.25));
  ASSERT_EQ(grown.size(), 2u);
  EXPECT_NEAR(grown[0], 4 * kPi * 2.25, 1e-12);
  EXPECT_NEAR(grown[1], 4 * kPi * 5.25, 1e-12);
  const auto shrunk = free_areas_angstrom2(balls, balls.lattice.alpha_on_lattice(-2));
  EXPECT_EQ(shrunk[0], 0);
  EXPECT_NEAR(shrunk[1], 4 * kPi * 2, 1e-12);
}

}  // namespace
}  // namespace alphascope
