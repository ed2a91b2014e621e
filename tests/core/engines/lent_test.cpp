// Engines that are lent a triangulation or a filtration answer from it, say so, and keep none.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "core/complex/compare.hpp"
#include "core/engine/engine.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/support/random_balls.hpp"

namespace alphascope {
namespace {

using testing::Random;

class LentEngine : public ::testing::Test {
 protected:
  LentEngine() {
    Random random(51);
    balls_ = std::make_shared<const BallSet>(testing::random_balls(random, 300, 1000, 50, 100));
    triangulation_ = std::make_shared<const Triangulation>(make_triangulation(*balls_, 1));
    filtration_ = std::make_shared<const Filtration>(balls_, *triangulation_);
  }

  AlphaComplex expected(double alpha, bool tetrahedra_only = false) const {
    return make_cgal_engine(balls_, {1})->compute({alpha, tetrahedra_only}, {});
  }

  std::shared_ptr<const BallSet> balls_;
  std::shared_ptr<const Triangulation> triangulation_;
  std::shared_ptr<const Filtration> filtration_;
};

TEST_F(LentEngine, AnswersEveryAlphaByThresholdOfTheFiltration) {
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    const auto engine = make(balls_, {1});
    for (const double alpha : {-3000.0, 100.0, 1e4, 1e300}) {
      for (const bool tetrahedra_only : {false, true}) {
        const AlphaComplex found =
            engine->compute({alpha, tetrahedra_only, {nullptr, filtration_}}, {});
        EXPECT_TRUE(compare(found, expected(alpha, tetrahedra_only)).identical()) << alpha;
        EXPECT_EQ(found.hash, expected(alpha, tetrahedra_only).hash);
        EXPECT_EQ(found.engine.route, "threshold of the whole filtration");
        EXPECT_TRUE(found.engine.rests_on_cgal);
        ASSERT_EQ(found.timings.stages.size(), 1u);
        EXPECT_EQ(found.timings.stages[0].label, stage::kThreshold);
        EXPECT_FALSE(found.timings.stages[0].setup);
      }
    }
    EXPECT_EQ(filtration_.use_count(), 1) << "an engine keeps what it was lent";
  }
}

TEST_F(LentEngine, GoesOnAsBeforeWhenNothingIsLentAnyMore) {
  const auto engine = make_cpu_engine(balls_, {1});
  EXPECT_EQ(engine->compute({100}, {}).engine.route, "dual edge clipping");
  EXPECT_EQ(engine->compute({90}, {}).engine.route, "filtration of cached complex, then threshold");
  engine->compute({90, false, {nullptr, filtration_}}, {});
  const AlphaComplex again = engine->compute({80}, {});
  EXPECT_EQ(again.engine.route, "dual edge clipping") << "kept beside what was lent";
  EXPECT_FALSE(again.engine.rests_on_cgal);
  EXPECT_TRUE(compare(again, expected(80)).identical());
}

TEST_F(LentEngine, SaysWhatItKeeps) {
  const auto engine = make_cpu_engine(balls_, {1});
  EXPECT_EQ(engine->kept_bytes(), 0u);
  const AlphaComplex complex = engine->compute({100}, {});
  const AlphaComplex copy = complex;  // without spare room
  EXPECT_GE(engine->kept_bytes(), bytes_of(copy)) << "a copy of it";
  engine->compute({90, false, {nullptr, filtration_}}, {});
  EXPECT_EQ(engine->kept_bytes(), 0u) << "somebody else has it all";
  const auto cgal = make_cgal_engine(balls_, {1});
  cgal->compute({100}, {});
  EXPECT_GE(cgal->kept_bytes(), filtration_->top_bytes());
}

TEST_F(LentEngine, DoesNotTriangulateAgain) {
  const auto engine = make_cgal_engine(balls_, {1});
  const AlphaComplex only = engine->compute({1e4, true, {triangulation_, nullptr}}, {});
  EXPECT_EQ(only.engine.route, "threshold of the whole triangulation");
  EXPECT_EQ(only.timings.setup_milliseconds(), 0);
  EXPECT_TRUE(compare(only, expected(1e4, true)).identical());
  const AlphaComplex whole = engine->compute({1e4, false, {triangulation_, nullptr}}, {});
  EXPECT_EQ(whole.engine.route, "filtration of the whole triangulation, then threshold");
  EXPECT_GT(whole.timings.setup_milliseconds(), 0);
  EXPECT_TRUE(compare(whole, expected(1e4)).identical());
  EXPECT_EQ(triangulation_.use_count(), 1);

  // The CPU engine, where it would triangulate.
  const auto cpu = make_cpu_engine(balls_, {1});
  const AlphaComplex all = cpu->compute({1e300, false, {triangulation_, nullptr}}, {});
  EXPECT_EQ(all.engine.route, "filtration of the whole triangulation, then threshold");
  EXPECT_TRUE(compare(all, expected(1e300)).identical());
}

TEST_F(LentEngine, HandsOverWhatItMade) {
  const auto engine = make_cgal_engine(balls_, {1});
  EXPECT_FALSE(engine->take().triangulation);
  engine->compute({100, true}, {});
  const Lent triangulation = engine->take();
  ASSERT_TRUE(triangulation.triangulation);
  EXPECT_FALSE(triangulation.filtration);
  EXPECT_TRUE(*triangulation.triangulation == *triangulation_);
  EXPECT_FALSE(engine->take().triangulation) << "kept although it was handed over";
  engine->compute({100, false}, {});
  const Lent filtration = engine->take();
  EXPECT_TRUE(filtration.filtration);
  EXPECT_FALSE(filtration.triangulation) << "the filtration replaces it";
  engine->compute({100, false, {}, true}, {});
  const Lent both = engine->take();
  EXPECT_TRUE(both.filtration);
  ASSERT_TRUE(both.triangulation);
  EXPECT_TRUE(*both.triangulation == *triangulation_);

  const auto cpu = make_cpu_engine(balls_, {1});
  cpu->compute({100}, {});
  EXPECT_FALSE(cpu->take().filtration) << "not of all alphas";
  cpu->compute({1e300}, {});
  const Lent whole = cpu->take();
  ASSERT_TRUE(whole.filtration);
  EXPECT_EQ(whole.filtration.use_count(), 1);
  const AlphaComplex found = cpu->compute({1e4, false, whole}, {});
  EXPECT_EQ(found.engine.route, "threshold of the whole filtration");
  EXPECT_TRUE(compare(found, expected(1e4)).identical());
}

TEST_F(LentEngine, RefusesWhatIsOfOtherBalls) {
  Random random(52);
  const auto other =
      std::make_shared<const BallSet>(testing::random_balls(random, 299, 1000, 50, 100));
  const auto triangulation = std::make_shared<const Triangulation>(make_triangulation(*other, 1));
  const auto filtration = std::make_shared<const Filtration>(other, *triangulation);
  const auto top = std::make_shared<const AlphaComplex>(expected(100));
  const auto bounded = std::make_shared<const Filtration>(balls_, top);
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    const auto engine = make(balls_, {1});
    EXPECT_THROW(engine->compute({1, false, {triangulation, nullptr}}, {}), std::invalid_argument);
    EXPECT_THROW(engine->compute({1, false, {nullptr, filtration}}, {}), std::invalid_argument);
    EXPECT_THROW(engine->compute({1, false, {nullptr, bounded}}, {}), std::invalid_argument);
  }
}

TEST_F(LentEngine, CanBeCancelled) {
  RunContext context;
  context.cancel.cancel();
  for (const auto& make : {make_cpu_engine, make_cgal_engine}) {
    EXPECT_THROW(make(balls_, {1})->compute({1, false, {nullptr, filtration_}}, context),
                 Cancelled);
  }
}

}  // namespace
}  // namespace alphascope
