// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that engines answer from known results of their balls, report it, add new results, and keep
// none.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/complex/compare.hpp"
#include "core/engine/engine.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/geometry/alpha.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

class EngineThatKnows : public ::testing::Test {
 protected:
  EngineThatKnows() {
    Random random(51);
    balls_ = std::make_shared<const BallSet>(testing::random_balls(random, 300, 1000, 50, 100));
    triangulation_ = std::make_shared<const Triangulation>(make_cgal_triangulation(*balls_, 1));
    filtration_ = std::make_shared<const Filtration>(balls_, *triangulation_);
  }

  AlphaComplex expected(double alpha, bool tetrahedra_only = false) const {
    return make_cgal_engine(balls_, {1})->compute({alpha, tetrahedra_only}, {});
  }
  // The answer, shared for the next one.
  std::shared_ptr<const AlphaComplex> shared(Engine& engine, double alpha,
                                             KnownResults& known) const {
    auto complex = std::make_shared<const AlphaComplex>(engine.compute({alpha}, known, {}));
    known.share(complex);
    EXPECT_TRUE(compare(*complex, expected(alpha)).identical()) << alpha;
    return complex;
  }
  std::string route(Engine& engine, double alpha, KnownResults& known) const {
    return shared(engine, alpha, known)->engine.route;
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<const Triangulation> triangulation_;
  std::shared_ptr<const Filtration> filtration_;
};

// The reference answers from CGAL's own triangulations.
TEST_F(EngineThatKnows, OfCgalTakesNoOthersResults) {
  const auto other = std::make_shared<const Triangulation>(make_triangulation(*balls_, 1));
  const auto filtration = std::make_shared<const Filtration>(balls_, other);
  for (const bool whole : {false, true}) {
    KnownResults known{{balls_, other, whole ? filtration : nullptr}, {}, {}};
    const AlphaComplex found = make_cgal_engine(balls_, {1})->compute({100}, known, {});
    EXPECT_EQ(found.engine.route, "regular triangulation, filtration, then threshold");
    EXPECT_TRUE(found.engine.rests_on_cgal);
    KnownResults same{{balls_, other, whole ? filtration : nullptr}, {}, {}};
    EXPECT_FALSE(make_cpu_engine(balls_, {1})->compute({100}, same, {}).engine.rests_on_cgal);
  }
}

TEST_F(EngineThatKnows, AnswersEveryAlphaByThresholdOfTheFiltration) {
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    const auto engine = make(balls_, {1});
    KnownResults known{{balls_, nullptr, filtration_}, {}, {}};
    for (const double alpha : {-3000.0, 100.0, 1e4, 1e300}) {
      for (const bool tetrahedra_only : {false, true}) {
        const AlphaComplex found = engine->compute({alpha, tetrahedra_only}, known, {});
        EXPECT_TRUE(compare(found, expected(alpha, tetrahedra_only)).identical()) << alpha;
        EXPECT_EQ(found.hash, expected(alpha, tetrahedra_only).hash);
        EXPECT_EQ(found.engine.route, "threshold of the whole filtration");
        EXPECT_TRUE(found.engine.rests_on_cgal);
        ASSERT_EQ(found.timings.stages.size(), 1u);
        EXPECT_EQ(found.timings.stages[0].label, stage::kThreshold);
        EXPECT_FALSE(found.timings.stages[0].setup);
      }
    }
    known = {};
    EXPECT_EQ(filtration_.use_count(), 1) << "an engine keeps what it was given";
  }
}

TEST_F(EngineThatKnows, SmallerAlphasAreThresholdsOfItsLastWholeComplex) {
  const auto engine = make_cpu_engine(balls_, {1});
  KnownResults known;
  EXPECT_EQ(route(*engine, 100, known), "dual edge clipping");
  engine->compute({120, true}, known, {});
  EXPECT_TRUE(known.complex) << "tetrahedra alone are no whole complex";
  EXPECT_EQ(route(*engine, 90, known), "filtration of cached complex, then threshold");
  EXPECT_EQ(route(*engine, 95, known), "threshold of cached filtration");
  EXPECT_EQ(route(*engine, 110, known), "dual edge clipping");
  EXPECT_FALSE(known.below) << "of a smaller alpha";
  EXPECT_EQ(route(*engine, 105, known), "filtration of cached complex, then threshold");
}

// The caller may keep an answer to itself. Later answers then compute again.
TEST_F(EngineThatKnows, AComplexIsNotCopied) {
  const auto engine = make_cpu_engine(balls_, {1});
  KnownResults known;
  engine->compute({100}, known, {});
  EXPECT_EQ(bytes_of(known), 0u);
  EXPECT_TRUE(known.wants_complex);
  EXPECT_EQ(engine->compute({90}, known, {}).engine.route, "dual edge clipping");
  const auto complex = shared(*engine, 100, known);
  EXPECT_EQ(known.complex, complex);
  EXPECT_EQ(bytes_of(known), bytes_of(*complex));
}

TEST_F(EngineThatKnows, AFiltrationTakesThePlaceOfTheLastComplex) {
  const auto engine = make_cpu_engine(balls_, {1});
  KnownResults known;
  shared(*engine, 100, known);
  known.add({balls_, nullptr, filtration_});
  EXPECT_EQ(route(*engine, 90, known), kThresholdRoute);
  EXPECT_FALSE(known.complex);
  EXPECT_EQ(bytes_of(known), bytes_of(ResultsForAllAlphas{balls_, nullptr, filtration_}));

  known.filtration = nullptr;
  shared(*engine, 100, known);
  shared(*engine, 90, known);
  EXPECT_TRUE(known.below);
  shared(*engine, 1e300, known);
  EXPECT_TRUE(known.filtration);
  EXPECT_FALSE(known.below);
}

TEST_F(EngineThatKnows, DoesNotTriangulateAgain) {
  const auto engine = make_cgal_engine(balls_, {1});
  KnownResults known{{balls_, triangulation_, nullptr}, {}, {}};
  const AlphaComplex only = engine->compute({1e4, true}, known, {});
  EXPECT_EQ(only.engine.route, "threshold of the whole triangulation");
  EXPECT_EQ(only.timings.setup_milliseconds(), 0);
  EXPECT_TRUE(compare(only, expected(1e4, true)).identical());
  EXPECT_FALSE(known.filtration);
  const AlphaComplex whole = engine->compute({1e4}, known, {});
  EXPECT_EQ(whole.engine.route, "filtration of the whole triangulation, then threshold");
  EXPECT_GT(whole.timings.setup_milliseconds(), 0);
  EXPECT_TRUE(compare(whole, expected(1e4)).identical());
  EXPECT_EQ(known.triangulation, triangulation_);

  // Here the CPU engine would triangulate.
  KnownResults another{{balls_, triangulation_, nullptr}, {}, {}};
  const auto cpu = make_cpu_engine(balls_, {1});
  EXPECT_EQ(route(*cpu, 1e300, another), "filtration of the whole triangulation, then threshold");
  known = another = {};
  EXPECT_EQ(triangulation_.use_count(), 1);
}

TEST_F(EngineThatKnows, AddsWhatItMakesOfAllBalls) {
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    const auto engine = make(balls_, {1});
    KnownResults known;
    EXPECT_EQ(route(*engine, 1e300, known), "regular triangulation, filtration, then threshold");
    ASSERT_TRUE(known.triangulation);
    ASSERT_TRUE(known.filtration);
    EXPECT_EQ(known.balls, balls_);
    EXPECT_TRUE(*known.triangulation == *triangulation_);
    EXPECT_EQ(known.filtration.use_count(), 1) << "an engine keeps what it has made";
    EXPECT_EQ(route(*engine, 1e4, known), kThresholdRoute);
  }
  KnownResults known;
  make_cgal_engine(balls_, {1})->compute({100, true}, known, {});
  EXPECT_TRUE(known.triangulation);
  EXPECT_FALSE(known.filtration) << "nobody needs it for tetrahedra";
}

TEST_F(EngineThatKnows, LeavesWhatWasMadeBeforeItWasCancelled) {
  const auto engine = make_cgal_engine(balls_, {1});
  KnownResults known;
  RunContext context;
  context.progress = [&](std::string_view stage, double) {
    if (stage == stage::kClassification) context.cancel.cancel();
  };
  EXPECT_THROW(engine->compute({100}, known, context), Cancelled);
  EXPECT_TRUE(known.triangulation);
  EXPECT_FALSE(known.filtration);
  EXPECT_EQ(route(*engine, 100, known), "filtration of the whole triangulation, then threshold");
}

TEST_F(EngineThatKnows, RefusesWhatIsOfOtherBalls) {
  Random random(52);
  const auto other =
      std::make_shared<const BallSet>(testing::random_balls(random, 299, 1000, 50, 100));
  const auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*other, 1));
  const auto filtration = std::make_shared<const Filtration>(other, *triangulation);
  const auto top = std::make_shared<const AlphaComplex>(expected(100));
  const auto bounded = std::make_shared<const Filtration>(balls_, top);
  const KnownResults wrong[] = {
      {{other, triangulation, nullptr}, {}, {}}, {{balls_, triangulation, nullptr}, {}, {}},
      {{balls_, nullptr, filtration}, {}, {}},   {{other, nullptr, filtration_}, {}, {}},
      {{balls_, nullptr, bounded}, {}, {}},      {{nullptr, triangulation_, nullptr}, {}, {}},
      {{other, nullptr, nullptr}, top, nullptr}, {{balls_, nullptr, nullptr}, nullptr, filtration}};
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    const auto engine = make(balls_, {1});
    for (KnownResults known : wrong) {
      EXPECT_THROW(engine->compute({1}, known, {}), std::invalid_argument);
    }
  }
}

TEST_F(EngineThatKnows, CanBeCancelled) {
  RunContext context;
  context.cancel.cancel();
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    KnownResults known{{balls_, nullptr, filtration_}, {}, {}};
    EXPECT_THROW(make(balls_, {1})->compute({1}, known, context), Cancelled);
    EXPECT_TRUE(known.filtration);
  }
}

}  // namespace
}  // namespace alphascope
