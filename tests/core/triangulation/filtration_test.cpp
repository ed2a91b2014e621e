// SPDX-License-Identifier: GPL-3.0-or-later
// Tests thresholds of a filtration, made from the whole triangulation or from a complex at
// alpha_max.
#include "core/triangulation/filtration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/complex/compare.hpp"
#include "core/complex/face_groups.hpp"
#include "core/engine/engine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/keeping_engine.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/reference/rational_oracle.hpp"

namespace alphascope {
namespace {

using testing::NamedBalls;
using testing::Random;
using testing::RationalOracle;

// A cluster of balls and one very distant ball. Values of the latter's simplices are near 6e16 and
// differ by about 1e9, less than the distance of floats there. Thresholds between them separate
// values of one float.
TEST(Filtration, SeparatesValuesOfOneFloat) {
  Random random(20);
  std::size_t separated = 0;
  for (int round = 0; round < 120; ++round) {
    BallSet balls = testing::random_balls(random, 7, 2, 1, 2);
    testing::add_ball(balls, 500000000 - round, 12, 7, 1);
    const auto shared = std::make_shared<const BallSet>(balls);
    const RationalOracle oracle(balls);
    const Filtration filtration(shared, make_triangulation(balls, 1, {}), {});
    std::vector<mpq_class> values;
    for (const auto& [simplex, value] : oracle.alpha_values()) values.push_back(value);
    std::sort(values.begin(), values.end());
    for (std::size_t n = 0; n + 1 < values.size(); ++n) {
      const double alpha = mpq_class((values[n] + values[n + 1]) / 2).get_d();
      if (!(values[n] <= mpq_class(alpha) && mpq_class(alpha) < values[n + 1])) continue;
      separated += testing::nearest_float(values[n]) == testing::nearest_float(values[n + 1]);
      const AlphaComplex expected = oracle.complex(alpha);
      const AlphaComplex found = threshold(filtration, alpha, false);
      ASSERT_TRUE(compare(found, expected).identical());
      ASSERT_EQ(found.hash, expected.hash);
      const AlphaComplex only = threshold(filtration, alpha, true);
      ASSERT_TRUE(compare(only, expected).identical());

      const Filtration bounded(shared, std::make_shared<AlphaComplex>(oracle.complex(alpha + 1)));
      ASSERT_TRUE(compare(threshold(bounded, alpha, false), expected).identical());
    }
  }
  EXPECT_GT(separated, 100u);
}

// A threshold updates a hash that is mostly known beforehand. It must be the sum over the
// simplices, for small and large sets, at alpha values, between them and beyond.
TEST(Filtration, TheHashIsThatOfTheSimplices) {
  Random random(29);
  std::vector<NamedBalls> sets = testing::large_hard_sets(random);
  sets.push_back({"many", testing::random_balls(random, 3000, 3000, 100, 300)});
  std::size_t different = 0;
  for (const NamedBalls& set : sets) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const Filtration filtration(balls, make_triangulation(*balls, 1));
    std::vector<double> alphas{-1e300, 1e300, std::numeric_limits<double>::infinity()};
    const auto& values = filtration.top().triangles.alpha_values;
    for (std::size_t n = 0; n < values.size(); n += values.size() / 40 + 1) {
      alphas.push_back(values[n]);
      alphas.push_back(std::nextafter(values[n], -1e30f));
    }
    std::uint64_t last = 0;
    for (const double alpha : alphas) {
      for (const bool only : {false, true}) {
        const AlphaComplex complex = threshold(filtration, alpha, only);
        ASSERT_EQ(complex.hash, complex_hash(complex)) << set.name << ", alpha " << alpha;
        different += complex.hash != std::exchange(last, complex.hash);
      }
    }
  }
  EXPECT_GT(different, 1000u);
}

TEST(Filtration, OfAComplexAnswersEverySmallerAlpha) {
  Random random(21);
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const auto engine = testing::keeping(make_cgal_engine(balls, {1}));
    const auto top = std::make_shared<AlphaComplex>(engine->compute({7}, {}));
    const Filtration filtration(balls, top);
    const auto units = [&](double alpha) { return balls->lattice.alpha_on_lattice(alpha); };
    EXPECT_EQ(filtration.alpha_max_on_lattice(), units(7));
    for (const double alpha : {-2.0, 0.0, 0.5, 1.0, 2.0, 3.5, 5.0, 7.0}) {
      EXPECT_TRUE(compare(threshold(filtration, units(alpha), false), engine->compute({alpha}, {}))
                      .identical())
          << set.name << ", alpha " << alpha;
    }
    EXPECT_THROW(threshold(filtration, units(7.5), false), std::invalid_argument);
    EXPECT_THROW(threshold(filtration, std::nan(""), false), std::invalid_argument);
  }
}

TEST(Filtration, AnswersTheSameWithTheTriangulationsTetrahedra) {
  Random random(18);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 200, 1000, 50, 100));
  auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*balls, 1));
  const Filtration own(balls, *triangulation), sharing(balls, triangulation);
  EXPECT_EQ(sharing.top().tetrahedra.simplices.data(), triangulation->tetrahedra.data());
  EXPECT_NE(own.top().tetrahedra.simplices.data(), triangulation->tetrahedra.data());
  triangulation.reset();
  for (const double alpha : {-1e4, 0.0, 1e4, 1e6, HUGE_VAL}) {
    const AlphaComplex found = threshold(sharing, alpha, false);
    EXPECT_TRUE(compare(found, threshold(own, alpha, false)).identical()) << alpha;
    EXPECT_EQ(found.tetrahedra.alpha_values.size(), found.tetrahedra.size());
  }
}

TEST(Filtration, NeedsAWholeComplex) {
  const auto balls = std::make_shared<const BallSet>();
  const auto only = std::make_shared<AlphaComplex>();
  only->tetrahedra_only = true;
  EXPECT_THROW(Filtration(balls, only), std::invalid_argument);
}

// Orthospheres exceed every float, so values are infinite and alpha decides exactly.
TEST(Filtration, KeepsValuesBeyondAllFloatsApart) {
  BallSet balls;
  balls.lattice.digits = 0;
  const int far = kMaxLatticeCoordinate;
  testing::add_ball(balls, -far, -far, 0, 1);
  testing::add_ball(balls, far, -far + 1, 0, 1);
  testing::add_ball(balls, -far + 1, far, 0, 1);
  testing::add_ball(balls, far, far, 1, 1);
  testing::add_ball(balls, far - 7, far - 9, 0, 1);
  const RationalOracle oracle(balls);
  const Filtration filtration(std::make_shared<const BallSet>(balls),
                              make_triangulation(balls, 1, {}), {});
  for (const double alpha :
       {1e17, 1e20, 1e30, 1e40, 1e60, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(compare(threshold(filtration, alpha, false), oracle.complex(alpha)).identical())
        << alpha;
  }
}

TEST(Filtration, ClassesFollowFromTheSimplices) {
  Random random(22);
  for (const NamedBalls& set : testing::large_hard_sets(random)) {
    AlphaComplex complex =
        make_cgal_engine(std::make_shared<const BallSet>(set.balls), {1})->compute({2}, {});
    const AlphaComplex before = complex;
    std::fill(complex.edges.classes.begin(), complex.edges.classes.end(), SimplexClass::singular);
    classify(complex);
    EXPECT_TRUE(compare(complex, before).identical()) << set.name;
  }
}

// Cancelled before the start, or at any report of progress. It ends before the next report.
TEST(Filtration, ItsMakingCanBeCancelled) {
  Random random(26);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 2000, 3000, 100, 300));
  const auto top = std::make_shared<const AlphaComplex>(make_cpu_engine(balls)->compute({1e4}, {}));
  const Triangulation triangulation = make_triangulation(*balls, 1, {});
  const auto of_complex = [&](const RunContext& context) { Filtration(balls, top, context); };
  const auto of_triangulation = [&](const RunContext& context) {
    Filtration(balls, triangulation, context);
  };
  for (const auto& make : {std::function<void(const RunContext&)>(of_complex),
                           std::function<void(const RunContext&)>(of_triangulation)}) {
    int reports = 0;
    RunContext counting;
    counting.progress = [&](std::string_view, double) { ++reports; };
    make(counting);
    EXPECT_GE(reports, 3);
    for (int last = 1; last <= reports; ++last) {
      int seen = 0;
      RunContext context;
      context.progress = [&](std::string_view, double) {
        if (++seen == last) context.cancel.cancel();
      };
      EXPECT_THROW(make(context), Cancelled) << "at report " << last;
      EXPECT_EQ(seen, last) << "went on for another part";
    }
  }
}

TEST(Filtration, FacesAreNotSortedForOneWhoCancelled) {
  Random random(27);
  const BallSet balls = testing::random_balls(random, 500, 1000, 50, 200);
  Triangulation triangulation = make_triangulation(balls, 1, {});
  const Simplices<4> before = triangulation.tetrahedra;
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(FaceGroups<3>(triangulation.tetrahedra, cancel), Cancelled);
  EXPECT_THROW(sort_simplices<4>(triangulation.tetrahedra, balls.size(), cancel), Cancelled);
  EXPECT_EQ(triangulation.tetrahedra, before);
}

// A cancelled engine still works.
TEST(CpuEngine, CanBeCancelledWhileMakingAFiltration) {
  Random random(28);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 2000, 3000, 100, 300));
  const auto engine = testing::keeping(make_cpu_engine(balls, {1}));
  engine->compute({1e4}, {});
  for (const int last : {1, 2, 3}) {
    int seen = 0;
    RunContext context;
    context.progress = [&](std::string_view stage, double) {
      EXPECT_EQ(stage, stage::kClassification);
      if (++seen == last) context.cancel.cancel();
    };
    EXPECT_THROW(engine->compute({9e3}, context), Cancelled) << last;
  }
  const AlphaComplex found = engine->compute({9e3}, {});
  EXPECT_EQ(found.engine.route, "filtration of cached complex, then threshold");
  EXPECT_EQ(found.hash, make_cgal_engine(balls, {1})->compute({9e3}, {}).hash);
}

// Setup is paid once. Later alphas are thresholds and say so.
TEST(CgalEngine, TimesSetupApart) {
  Random random(24);
  const auto engine = testing::keeping(make_cgal_engine(
      std::make_shared<const BallSet>(testing::random_balls(random, 500, 1000, 50, 200)), {1}));
  const AlphaComplex only = engine->compute({100, true}, {});
  EXPECT_EQ(only.engine.route, "regular triangulation, then threshold");
  ASSERT_EQ(only.timings.stages.size(), 2u);
  EXPECT_EQ(only.timings.stages[0].label, stage::kTriangulation);
  EXPECT_TRUE(only.timings.stages[0].setup);
  EXPECT_FALSE(only.timings.stages[1].setup);
  EXPECT_EQ(engine->compute({90, true}, {}).engine.route, "threshold of the whole triangulation");

  const AlphaComplex whole = engine->compute({100}, {});
  EXPECT_EQ(whole.engine.route, "filtration of the whole triangulation, then threshold");
  ASSERT_EQ(whole.timings.stages.size(), 2u);
  EXPECT_EQ(whole.timings.stages[0].label, stage::kClassification);
  EXPECT_TRUE(whole.timings.stages[0].setup);

  const AlphaComplex later = engine->compute({50}, {});
  EXPECT_EQ(later.engine.route, "threshold of the whole filtration");
  ASSERT_EQ(later.timings.stages.size(), 1u);
  EXPECT_EQ(later.timings.setup_milliseconds(), 0);
  EXPECT_GE(later.timings.wall_milliseconds, later.timings.stages[0].milliseconds);
}

// A result that was taken from a whole triangulation says so, and also if that was CGAL's.
TEST(Engines, SayWhatThisRunDid) {
  Random random(25);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 300, 1000, 50, 100));
  const AlphaComplex whole = make_cgal_engine(balls, {1})->compute({100}, {});
  EXPECT_EQ(whole.engine.route, "regular triangulation, filtration, then threshold");
  EXPECT_TRUE(whole.engine.of_whole);
  EXPECT_TRUE(whole.engine.rests_on_cgal);
  const AlphaComplex inserted = make_cpu_engine(balls, {1})->compute({1e9}, {});
  EXPECT_EQ(inserted.engine.route, whole.engine.route);
  EXPECT_TRUE(inserted.engine.of_whole);
  EXPECT_FALSE(inserted.engine.rests_on_cgal);

  const auto engine = testing::keeping(make_cpu_engine(balls, {1}));
  const AlphaComplex clipped = engine->compute({100}, {});
  EXPECT_EQ(clipped.engine.route, "dual edge clipping");
  EXPECT_FALSE(clipped.engine.of_whole);
  EXPECT_FALSE(clipped.engine.rests_on_cgal);
  EXPECT_FALSE(compare(clipped, whole).both_rest_on_cgal);
  const AlphaComplex smaller = engine->compute({50}, {});
  EXPECT_EQ(smaller.engine.route, "filtration of cached complex, then threshold");
  EXPECT_FALSE(smaller.engine.rests_on_cgal);
  EXPECT_EQ(engine->compute({40}, {}).engine.route, "threshold of cached filtration");

  const AlphaComplex triangulated = engine->compute({1e300}, {});
  EXPECT_EQ(triangulated.engine.route, "regular triangulation, filtration, then threshold");
  EXPECT_TRUE(triangulated.engine.of_whole);
  EXPECT_FALSE(compare(triangulated, whole).both_rest_on_cgal);
  const AlphaComplex later = engine->compute({100}, {});
  EXPECT_EQ(later.engine.route, "threshold of the whole filtration");
  EXPECT_TRUE(compare(later, whole).identical());
  EXPECT_TRUE(later.engine.of_whole);
  EXPECT_FALSE(compare(later, whole).both_rest_on_cgal);
}

}  // namespace
}  // namespace alphascope
