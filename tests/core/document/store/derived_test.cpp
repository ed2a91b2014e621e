// The derived results themselves, made by a store.
#include "core/document/store/derived.hpp"

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

}  // namespace
}  // namespace alphascope
