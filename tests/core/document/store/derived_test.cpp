// SPDX-License-Identifier: GPL-3.0-or-later
// Tests triangulation and filtration as results of a store.
#include "core/document/store/derived.hpp"

#include "core/complex/triangulation.hpp"
#include "core/document/store/inputs.hpp"
#include "core/engine/engine.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/core/document/store/store_fixture.hpp"
#include "tests/support/five_balls.hpp"

namespace alphascope {
namespace {

struct DerivedTest : testing::StoreTest {};

TEST_F(DerivedTest, TheFiltrationFollowsFromTheTriangulation) {
  budget = 1'000'000'000;
  Inputs in;
  testing::Random random(1);
  in.balls = std::make_shared<const BallSet>(testing::five_balls(random, 0));
  in.balls_key = 1;
  const auto filtration = settle(whole_filtration(), in).value;
  ASSERT_TRUE(filtration);
  const auto triangulation = settle(whole_triangulation(), in).value;
  ASSERT_TRUE(triangulation);
  EXPECT_EQ(filtration->top().tetrahedra.size(), triangulation->tetrahedra.size());
}

// Results that an engine made go to the store, and from there to the next request.
TEST_F(DerivedTest, TheStoreOwnsWhatAnEngineMadeOfAllBalls) {
  budget = 1'000'000'000;
  Inputs in;
  EXPECT_FALSE(results_for_all_alphas(store, in)) << "there is no molecule";
  testing::Random random(1);
  in.balls = std::make_shared<const BallSet>(testing::five_balls(random, 0));
  in.balls_key = 1;
  EXPECT_FALSE(results_for_all_alphas(store, in));
  KnownResults known;
  const auto engine = make_cgal_engine(in.balls, {1});
  const AlphaComplex first = engine->compute({10}, known, {});
  const Filtration* const of_engine = known.filtration.get();
  give_results_for_all_alphas(store, in, std::exchange(known, {}));
  const ResultsForAllAlphas had = results_for_all_alphas(store, in);
  EXPECT_EQ(had.balls, in.balls);
  EXPECT_EQ(had.filtration.get(), of_engine);
  EXPECT_TRUE(had.triangulation);
  EXPECT_GT(store.held_bytes(), 0u);
  known.add(had);
  known.balls = had.balls;
  const AlphaComplex second = engine->compute({10}, known, {});
  EXPECT_EQ(second.engine.route, kThresholdRoute);
  EXPECT_EQ(second.hash, first.hash);

  in.balls_key = 2;
  EXPECT_FALSE(results_for_all_alphas(store, in)) << "of other balls";
}

}  // namespace
}  // namespace alphascope
