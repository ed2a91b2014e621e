// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that counts in the signature are those of the complexes themselves.
#include "core/document/alpha/signature.hpp"

#include <gtest/gtest.h>

#include "core/document/store/definition.hpp"
#include "core/engine/engine.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

TEST(Signature, CountsWhatTheComplexesHave) {
  testing::Random random(5);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 200, 9000, 1000, 2000));
  const Signature signature = make_signature(Filtration(balls, make_triangulation(*balls, 1)));
  const auto engine = testing::keeping(make_cgal_engine(balls));
  for (const double alpha : {-3.7, -1.1, 0.0, 0.9, 3.3, 20.0, 400.0, 1e9}) {
    const AlphaComplex k = engine->compute({alpha}, {});
    EXPECT_EQ(signature.count(0, alpha), k.vertices.size()) << alpha;
    EXPECT_EQ(signature.count(1, alpha), k.edges.size()) << alpha;
    EXPECT_EQ(signature.count(2, alpha), k.triangles.size()) << alpha;
    EXPECT_EQ(signature.count(3, alpha), k.tetrahedra.size()) << alpha;
    EXPECT_EQ(signature.euler(alpha), k.euler_characteristic()) << alpha;
  }
  EXPECT_EQ(signature.count(0, signature.least_alpha() - 100), 0u);
  EXPECT_GT(signature.count(0, signature.least_alpha() + 100), 0u);
}

TEST(Signature, OfNothingIsZero) {
  EXPECT_EQ(Signature().euler(1), 0);
  EXPECT_EQ(Signature().least_alpha(), 0);
}

}  // namespace
}  // namespace alphascope
