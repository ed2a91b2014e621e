// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a trace has the exact values of the tables that were followed, one point for each
// radius, and that it stays within its limits.
#include "core/cavity_identity/cavity_trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity_identity/cavity_curves.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/molecules.hpp"

namespace alphascope {
namespace {

using Trace = std::shared_ptr<const CavityTrace>;

// Tables of one molecule, each of which continues the one before.
class Followed {
 public:
  explicit Followed(const std::string& name) : balls_(testing::sample_balls(name)) {}

  const CavityTable& go(double radius, double alpha = 0, bool split = false) {
    const auto balls = std::make_shared<const BallSet>(with_solvent(*balls_, radius));
    const auto ground = std::make_shared<const CavityGround>(make_cavity_ground(
        balls, std::make_shared<const Triangulation>(make_triangulation(*balls, 1))));
    CavityParameters question{alpha, radius};
    question.split_networks = split;
    const auto table = std::make_shared<const CavityTable>(make_cavity_table(ground, question));
    numbers_ = numbers_.table ? next_numbers(numbers_, table) : first_numbers(table);
    trace_ = next_trace(trace_.get(), numbers_, limits_);
    return *table;
  }
  void begin_anew() { numbers_ = {}; }
  void limit(const TraceLimits& limits) { limits_ = limits; }

  std::vector<double> radii() const {
    std::vector<double> radii;
    for (const auto& point : trace_->points) radii.push_back(point->solvent_radius_angstrom);
    return radii;
  }
  const BallSet& balls() const { return *balls_; }
  const CavityNumbers& numbers() const { return numbers_; }
  const TracedPoint& point(std::size_t n) const { return *trace_->points.at(n); }
  std::size_t cavities() const {
    std::size_t all = 0;
    for (const auto& point : trace_->points) all += point->cavities.size();
    return all;
  }

 private:
  std::shared_ptr<const BallSet> balls_;
  CavityNumbers numbers_;
  Trace trace_;
  TraceLimits limits_;
};

using Radii = std::vector<double>;

TEST(CavityTrace, PointsAreTheValuesOfTheirTablesWithTheNumbersThatStay) {
  Followed followed("4hhb.pdb.gz");
  std::size_t checked = 0;
  for (const double radius : {1.4, 1.43, 1.5, 1.2, 1.35}) {
    const CavityTable& table = followed.go(radius);
    const Radii radii = followed.radii();
    EXPECT_TRUE(std::is_sorted(radii.begin(), radii.end()));
    const auto at = std::find(radii.begin(), radii.end(), radius);
    ASSERT_NE(at, radii.end());
    const TracedPoint& point = followed.point(static_cast<std::size_t>(at - radii.begin()));
    ASSERT_EQ(point.cavities.size(), table.found.cavities.size());
    for (std::size_t c = 0; c < table.found.cavities.size(); ++c) {
      const TracedCavity* cavity = point.find(followed.numbers().of[c]);
      ASSERT_TRUE(cavity);
      EXPECT_EQ(cavity->volume_sa_angstrom3, table.measures[c].volume_sa_angstrom3);
      EXPECT_EQ(cavity->area_sa_angstrom2, table.measures[c].area_sa_angstrom2);
      EXPECT_EQ(cavity->mouths, table.found.cavities[c].mouths.size());
      ++checked;
    }
    EXPECT_EQ(point.find(followed.numbers().used), nullptr);
  }
  EXPECT_GT(checked, 200u);
  EXPECT_EQ(followed.radii(), (Radii{1.2, 1.35, 1.4, 1.43, 1.5}));
}

// Sums have the very bits of a curve's sums, so that a curve changes no value that was shown.
TEST(CavityTrace, TotalsAreThoseOfTheCurves) {
  Followed followed("1crn.pdb");
  followed.go(0.8);
  const CavityCurves curves = curves_against_solvent(followed.balls(), 0, {0.8});
  double voids = 0, pockets = 0, area = 0;
  std::size_t mouths = 0;
  for (const CurveCavity& cavity : curves.samples[0].cavities) {
    (cavity.is_void ? voids : pockets) += cavity.volume_sa_angstrom3;
    if (!cavity.is_void) area += cavity.area_sa_angstrom2;
    mouths += cavity.mouths;
  }
  EXPECT_GT(mouths, 0u);
  EXPECT_EQ(followed.point(0).pockets.mouths, mouths);
  EXPECT_GT(pockets, 0);
  EXPECT_EQ(followed.point(0).voids.volume_sa_angstrom3, voids);
  EXPECT_EQ(followed.point(0).pockets.volume_sa_angstrom3, pockets);
  EXPECT_EQ(followed.point(0).pockets.area_sa_angstrom2, area);
}

TEST(CavityTrace, ARadiusThatComesBackIsOnePoint) {
  Followed followed("1crn.pdb");
  followed.go(0.8);
  followed.go(0.9);
  followed.go(0.8);
  EXPECT_EQ(followed.radii(), (Radii{0.8, 0.9}));
}

TEST(CavityTrace, BeginsAnewForAnotherQuestionAndForNewNumbers) {
  Followed followed("1crn.pdb");
  followed.go(0.8);
  followed.go(0.9);
  followed.go(0.9, 0.5);
  EXPECT_EQ(followed.radii(), Radii{0.9}) << "another alpha";
  followed.go(1, 0.5);
  followed.go(1, 0.5, true);
  EXPECT_EQ(followed.radii(), Radii{1}) << "networks are split";
  followed.go(1.1, 0.5, true);
  followed.begin_anew();
  followed.go(1.2, 0.5, true);
  EXPECT_EQ(followed.radii(), Radii{1.2}) << "numbers begin anew";
}

TEST(CavityTrace, BeyondItsLimitsTheMostCrowdedPointsLeave) {
  Followed followed("1crn.pdb");
  followed.limit({4, 1'000'000});
  for (const double radius : {0.5, 0.6, 1.0, 1.5, 0.55}) followed.go(radius);
  EXPECT_EQ(followed.radii(), (Radii{0.5, 0.55, 1.0, 1.5})) << "the newest point stays";
  followed.go(0.7);
  EXPECT_EQ(followed.radii(), (Radii{0.5, 0.7, 1.0, 1.5}));
  const std::size_t cavities = followed.cavities();
  followed.limit({4, cavities / 2});
  followed.go(0.8);
  EXPECT_LE(followed.cavities(), cavities / 2);
  EXPECT_EQ(std::ranges::count(followed.radii(), 0.8), 1);
  followed.limit({4, 1});
  followed.go(0.5);
  EXPECT_EQ(followed.radii(), Radii{0.5}) << "the newest point stays, however large it is";
}

}  // namespace
}  // namespace alphascope
