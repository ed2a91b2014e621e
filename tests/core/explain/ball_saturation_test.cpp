// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the alpha from which each ball is saturated against levels of the filtration, complexes
// below and above it, and the sentences.
#include "core/explain/ball_saturation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/complex/alpha_complex.hpp"
#include "core/document/explain/saturation_text.hpp"
#include "core/document/explain/steps_json.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/predicates/exact_alpha.hpp"
#include "core/rounds/thesis_rounds.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/molecules.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using State = BallSaturation::State;

// A vertex is interior from the largest ortho-radius of its star on.
void expect_those_of_the_filtration(const BallSet& balls) {
  const auto shared = std::make_shared<const BallSet>(balls);
  const Triangulation all = make_triangulation(balls, 1);
  const Filtration filtration(shared, all);
  const auto& vertices = filtration.top().vertices.simplices;
  for (BallIndex i = 0; i < balls.size(); ++i) {
    SCOPED_TRACE(i);
    const BallSaturation is = ball_saturation(balls, i);
    if (all.dimension < 3) {
      EXPECT_EQ(is.state, State::flat);
      continue;
    }
    const auto at = std::find(vertices.begin(), vertices.end(), std::array{i});
    const std::size_t star = static_cast<std::size_t>(
        std::count_if(all.tetrahedra.begin(), all.tetrahedra.end(),
                      [&](const auto& t) { return std::find(t.begin(), t.end(), i) != t.end(); }));
    EXPECT_EQ(is.tetrahedra, star);
    EXPECT_EQ(is.state == State::hidden, at == vertices.end());
    if (at == vertices.end()) continue;
    const float level =
        filtration.levels().vertices.interior_from[static_cast<std::size_t>(at - vertices.begin())];
    EXPECT_EQ(is.state == State::saturates, !std::isnan(level));
    if (is.state != State::saturates) continue;
    EXPECT_EQ(ortho_radius_rounded(balls, is.last), level);
    EXPECT_NEAR(is.angstrom2, balls.lattice.square_angstrom(level), 1e-5 * std::fabs(level) + 1e-9);
  }
}

TEST(BallSaturation, IsTheLevelOfTheFiltration) {
  testing::Random random(5);
  for (const auto& set : testing::small_hard_sets(random, 16)) {
    SCOPED_TRACE(set.name);
    expect_those_of_the_filtration(set.balls);
  }
  for (int n = 0; n < 4; ++n) {
    expect_those_of_the_filtration(testing::random_balls(random, 50, 12, 1, 5));
  }
  expect_those_of_the_filtration(*testing::sample_balls("1crn.pdb"));
}

// In its round a ball is saturated, in the round before it is not.
TEST(BallSaturation, HasItsRound) {
  const auto balls = testing::sample_balls("1crn.pdb");
  const Triangulation all = make_triangulation(*balls, 1);
  const auto saturated_at = [&](std::size_t round) {
    const LatticeAlpha alpha = balls->lattice.alpha_on_lattice(alpha_of_round(round));
    Simplices<4> known;
    for (const auto& t : all.tetrahedra) {
      if (compare_ortho_radius(*balls, t, alpha) <= 0) known.push_back(t);
    }
    return saturated_balls(balls->size(), known);
  };
  std::size_t saturating = 0;
  for (BallIndex i = 0; i < balls->size(); i += 7) {
    const BallSaturation is = ball_saturation(*balls, i);
    if (is.state != State::saturates) continue;
    ++saturating;
    ASSERT_GT(is.round, 0u);
    EXPECT_TRUE(saturated_at(is.round)[i]) << i;
    if (is.round > 1) EXPECT_FALSE(saturated_at(is.round - 1)[i]) << i;
  }
  EXPECT_GT(saturating, 30u);
}

TEST(BallSaturation, RefusesBallsThatAreNotThere) {
  EXPECT_THROW(ball_saturation(*testing::sample_balls("1crn.pdb"), 327), std::invalid_argument);
}

TEST(BallSaturation, CanBeCancelled) {
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(ball_saturation(*testing::sample_balls("1crn.pdb"), 0, context), Cancelled);
}

TEST(BallSaturation, InSentencesAndJson) {
  BallSaturation is{State::saturates, 24, 29.0148, {3, 5, 8, 9}, 3};
  EXPECT_EQ(saturation_text(is),
            "Saturated from α = 29.0148 Å² (the thesis' round 3, α = 40 Å²): its star is final, "
            "24 tetrahedra.");
  EXPECT_EQ(saturation_json(is).dump(),
            R"({"state":"saturates","tetrahedra":24,"from_alpha_angstrom2":29.0148,)"
            R"("last_tetrahedron":[3,5,8,9],"round":3,"round_alpha_angstrom2":40.0})");
  is.round = 0;
  EXPECT_NE(saturation_text(is).find("after all of the thesis' rounds"), std::string::npos);
  EXPECT_FALSE(saturation_json(is).contains("round"));
  for (const State state : {State::on_hull, State::hidden, State::flat}) {
    is.state = state;
    std::string text = saturation_text(is);
    text.front() = static_cast<char>(std::tolower(text.front()));
    EXPECT_NE((" " + text).find("ever saturated"), std::string::npos) << text;
    EXPECT_EQ(saturation_json(is).size(), 2u);
  }
}

}  // namespace
}  // namespace alphascope
