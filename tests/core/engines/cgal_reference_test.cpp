// SPDX-License-Identifier: GPL-3.0-or-later
// Tests every engine against CGAL's Fixed_alpha_shape_3 and Regular_triangulation_3, used directly.
#include <gtest/gtest.h>

#include <vector>

#include "core/complex/compare.hpp"
#include "core/neighbours/coincident.hpp"
#include "tests/support/engines.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/cgal_reference.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

using testing::EngineFactory;
using testing::NamedBalls;
using testing::Random;

class DirectCgal : public testing::EngineSuite {};
INSTANTIATE_TEST_SUITE_P(Engines, DirectCgal, ::testing::ValuesIn(testing::engines()),
                         testing::engine_name);

// Fixed_alpha_shape_3 has no alpha values; everything else must agree.
void expect_equals_alpha_shape(const BallSet& balls, Engine& engine, double alpha_angstrom2) {
  const double alpha = balls.lattice.alpha_on_lattice(alpha_angstrom2).nearest();
  const AlphaComplex expected = testing::fixed_alpha_shape(balls, alpha).complex;
  const AlphaComplex found = engine.compute({alpha_angstrom2}, {});
  Comparison comparison = compare(found, expected);
  comparison.alpha_values_differing = 0;
  ASSERT_TRUE(comparison.identical()) << "alpha " << alpha_angstrom2;
  ASSERT_EQ(found.hash, expected.hash);

  const auto cells = testing::regular_cells(balls, alpha).tetrahedra;
  ASSERT_EQ(cells.size(), found.tetrahedra.size());
}

BallSet without_coincident(const BallSet& balls) {
  const std::vector<bool> hidden = coincident_hidden(balls);
  std::vector<BallIndex> kept;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    if (hidden.empty() || !hidden[i]) kept.push_back(i);
  }
  return testing::permuted(balls, kept);
}

std::vector<double> some_alphas() {
  if (testing::kAddressSanitizer) return {-1, 0.25, 1, 3, 40};
  return {-4, -1, 0, 0.25, 0.5, 0.75, 1, 1.25, 2, 3, 7, 40};
}

void expect_hard_sets_agree(const EngineFactory& factory, std::uint64_t seed, int rounds) {
  Random random(seed);
  for (int round = 0; round < rounds; ++round) {
    for (const NamedBalls& set : testing::large_hard_sets(random, factory.balls_of_large_sets())) {
      if (set.name.starts_with("co") && set.name != "cospherical shells") continue;  // flat
      SCOPED_TRACE(set.name);
      const auto balls = std::make_shared<const BallSet>(without_coincident(set.balls));
      const auto engine = factory.make(balls);
      const bool huge = set.name == "extremes of the lattice";
      const double unit = huge ? 1e15 : set.alpha_unit();
      for (const double alpha : some_alphas()) {
        expect_equals_alpha_shape(*balls, *engine, alpha * unit);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST_P(DirectCgal, AgreesOnHardSets) {
  expect_hard_sets_agree(GetParam(), 3, 1);
}

TEST_P(DirectCgal, AgreesOnManyHardSetsLong) {
  expect_hard_sets_agree(GetParam(), 4, 20);
}

TEST_P(DirectCgal, AgreesOnAMolecule) {
  ALPHASCOPE_NEED_TEST_DATA();
  for (const double solvent : {0.0, 1.4}) {
    const auto balls = testing::molecule_balls("ladder/1grm.crd", solvent);
    const auto engine = GetParam().make(balls);
    for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 1.4, 1.96, 3.0, 10.0}) {
      if (!GetParam().affords(*balls, alpha)) continue;
      expect_equals_alpha_shape(*balls, *engine, alpha);
    }
  }
}

TEST_P(DirectCgal, AgreesOnALargeMoleculeLong) {
  ALPHASCOPE_NEED_TEST_DATA();
  const auto balls = testing::molecule_balls("thesis/1k4c.crd.gz");
  const auto engine = GetParam().make(balls);
  for (const double alpha : {-1.0, 0.0, 1.4, 3.0, 10.0}) {
    if (!GetParam().affords(*balls, alpha)) continue;
    expect_equals_alpha_shape(*balls, *engine, alpha);
  }
}

}  // namespace
}  // namespace alphascope
