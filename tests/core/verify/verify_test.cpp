// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that verifier and comparison notice every kind of damage.
#include "core/verify/verify.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/complex/compare.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

class Damage : public ::testing::Test {
 protected:
  Damage() {
    Random random(11);
    balls_ = testing::random_balls(random, 200, 100, 10, 30);
    complex_ = make_cgal_engine(std::make_shared<const BallSet>(balls_), {1})->compute({300}, {});
  }

  AlphaComplex noticed_by_the_verifier(const char* what,
                                       const std::function<void(AlphaComplex&)>& damage) {
    AlphaComplex damaged = complex_;
    damage(damaged);
    for (const VerifyBy by : {VerifyBy::search, VerifyBy::triangulation}) {
      const Verification verification = verify(balls_, damaged, {}, by);
      EXPECT_GT(verification.failures, 0u) << what;
      EXPECT_FALSE(verification.messages.empty()) << what;
    }
    return damaged;
  }
  void expect_noticed(const char* what, const std::function<void(AlphaComplex&)>& damage) {
    const AlphaComplex damaged = noticed_by_the_verifier(what, damage);
    EXPECT_FALSE(compare(damaged, complex_).identical()) << what;
  }

  template <int N>
  static void erase(SimplexList<N>& list, std::size_t n) {
    list.simplices.erase(list.simplices.begin() + static_cast<std::ptrdiff_t>(n));
    list.alpha_values.erase(list.alpha_values.begin() + static_cast<std::ptrdiff_t>(n));
    list.classes.erase(list.classes.begin() + static_cast<std::ptrdiff_t>(n));
  }

  BallSet balls_;
  AlphaComplex complex_;
};

TEST_F(Damage, NothingIsWrongWithoutIt) {
  ASSERT_GT(complex_.tetrahedra.size(), 20u);
  for (const VerifyBy by : {VerifyBy::search, VerifyBy::triangulation}) {
    const Verification verification = verify(balls_, complex_, {}, by);
    EXPECT_TRUE(verification.ok()) << verification.messages.at(0);
    EXPECT_GT(verification.checks, 10'000u);
  }
  EXPECT_TRUE(compare(complex_, complex_).identical());
}

TEST_F(Damage, IsNoticed) {
  expect_noticed("a face is missing", [](AlphaComplex& c) { erase(c.triangles, 5); });
  expect_noticed("an edge is missing", [](AlphaComplex& c) { erase(c.edges, 7); });
  expect_noticed("a vertex is missing", [](AlphaComplex& c) { erase(c.vertices, 2); });
  expect_noticed("a tetrahedron is missing", [](AlphaComplex& c) { erase(c.tetrahedra, 3); });
  expect_noticed("two simplices are swapped",
                 [](AlphaComplex& c) { std::swap(c.edges.simplices[3], c.edges.simplices[4]); });
  expect_noticed("vertices are swapped", [](AlphaComplex& c) {
    std::swap(c.edges.simplices[3][0], c.edges.simplices[3][1]);
  });
  expect_noticed("no such ball", [](AlphaComplex& c) { c.vertices.simplices.back()[0] = 999; });
  expect_noticed("a tetrahedron's value is off by one bit", [](AlphaComplex& c) {
    c.tetrahedra.alpha_values[2] = std::nextafter(c.tetrahedra.alpha_values[2], 1e30f);
  });
  expect_noticed("an edge's value is off by one bit", [](AlphaComplex& c) {
    c.edges.alpha_values[2] = std::nextafter(c.edges.alpha_values[2], -1e30f);
  });
}

// An index beyond the end of a list is reported before it is used, in each dimension.
TEST_F(Damage, InAnyListIsNoticed) {
  const auto each = [&](const char* of, auto list) {
    SCOPED_TRACE(of);
    noticed_by_the_verifier("no such ball", [&](AlphaComplex& c) {
      (c.*list).simplices.back().back() = std::numeric_limits<BallIndex>::max() / 2;
    });
    noticed_by_the_verifier("a class is lacking",
                            [&](AlphaComplex& c) { (c.*list).classes.pop_back(); });
    noticed_by_the_verifier("a value is lacking",
                            [&](AlphaComplex& c) { (c.*list).alpha_values.pop_back(); });
    noticed_by_the_verifier("a simplex is there twice", [&](AlphaComplex& c) {
      (c.*list).simplices[1] = (c.*list).simplices[0];
    });
  };
  each("vertices", &AlphaComplex::vertices);
  each("edges", &AlphaComplex::edges);
  each("triangles", &AlphaComplex::triangles);
  each("tetrahedra", &AlphaComplex::tetrahedra);
}

// In each dimension, replaces each class by each other one. Nothing else is wrong.
TEST_F(Damage, EveryWrongClassIsNoticed) {
  std::size_t tried = 0;
  const auto each = [&](const char* of, auto list) {
    std::array<bool, 3> done{};
    const auto& classes = (complex_.*list).classes;
    for (std::size_t n = 0; n < classes.size(); ++n) {
      const auto now = static_cast<std::size_t>(classes[n]);
      if (std::exchange(done.at(now), true)) continue;
      for (const SimplexClass other :
           {SimplexClass::singular, SimplexClass::regular, SimplexClass::interior}) {
        if (other == classes[n]) continue;
        expect_noticed(of, [&](AlphaComplex& c) { (c.*list).classes[n] = other; });
        ++tried;
      }
    }
  };
  each("vertices", &AlphaComplex::vertices);
  each("edges", &AlphaComplex::edges);
  each("triangles", &AlphaComplex::triangles);
  each("tetrahedra", &AlphaComplex::tetrahedra);
  EXPECT_GE(tried, 18u);
}

// A tetrahedron with a ball inside its orthosphere, with all its faces and right values.
TEST_F(Damage, ConflictIsNoticed) {
  const auto some = std::make_shared<BallSet>(balls_);
  some->centres.resize(150);
  some->radii.resize(150);
  const AlphaComplex of_fewer_balls = make_cgal_engine(some, {1})->compute({300}, {});
  for (const VerifyBy by : {VerifyBy::search, VerifyBy::triangulation}) {
    EXPECT_TRUE(verify(*some, of_fewer_balls, {}, by).ok());
    const Verification verification = verify(balls_, of_fewer_balls, {}, by);
    EXPECT_GT(verification.failures, 0u);
  }
}

TEST_F(Damage, SimplicesAboveAlphaAreNoticed) {
  AlphaComplex damaged = complex_;
  damaged.alpha_on_lattice = 200;
  EXPECT_GT(verify(balls_, damaged, {}, VerifyBy::search).failures, 0u);
  EXPECT_GT(verify(balls_, damaged, {}, VerifyBy::triangulation).failures, 0u);
}

TEST(Compare, ListsWhatDiffers) {
  Random random(12);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 60, 100, 10, 40));
  const auto engine = testing::keeping(make_cgal_engine(balls, {1}));
  const AlphaComplex large = engine->compute({1000}, {}), small = engine->compute({100}, {});
  const Comparison comparison = compare(small, large);
  EXPECT_TRUE(comparison.edges.extra.empty());
  EXPECT_EQ(comparison.edges.missing.size(), large.edges.size() - small.edges.size());
  EXPECT_EQ(comparison.edges.common, small.edges.size());
  EXPECT_EQ(compare(large, small).edges.extra, comparison.edges.missing);
  EXPECT_EQ(comparison.alpha_values_differing, 0u);

  const AlphaComplex only = engine->compute({100, true}, {});
  EXPECT_TRUE(compare(only, small).identical());
  EXPECT_TRUE(compare(only, small).tetrahedra_only);
}

}  // namespace
}  // namespace alphascope
