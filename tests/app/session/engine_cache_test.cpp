// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which engines are kept, and what happens when one fails.
#include "app/session/engine_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/session/rounding_note.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/engines/engine_of_executors.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/app/session/fake_engine.hpp"

namespace alphascope {
namespace {

using test::fake_factory;
using test::FakeEngineLog;
using test::few_balls;

Request with_solvent_radius(double solvent) {
  Request request;
  request.solvent_radius_angstrom = solvent;
  return request;
}

TEST(EngineCache, KeepsTheEngineWhileOnlyAlphaMoves) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  Request request;
  for (double alpha : {0.0, 1.0, 2.0}) {
    request.alpha_angstrom2 = alpha;
    EXPECT_DOUBLE_EQ(cache.compute(balls, request, {}).complex.alpha_angstrom2(), alpha);
  }
  EXPECT_EQ(log.made, 1);
}

TEST(EngineCache, GrowsTheBallsAndKeepsTwoSettings) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  EXPECT_EQ(cache.compute(balls, with_solvent_radius(0), {}).balls, balls);
  EXPECT_EQ(cache.compute(balls, with_solvent_radius(1.4), {}).balls->radii.at(0), 3100);
  cache.compute(balls, with_solvent_radius(0), {});
  EXPECT_EQ(log.made, 2) << "both are kept";
  cache.compute(balls, with_solvent_radius(2), {});
  cache.compute(balls, with_solvent_radius(0), {});
  EXPECT_EQ(log.made, 3) << "the one used longest ago went";
  cache.compute(balls, with_solvent_radius(1.4), {});
  EXPECT_EQ(log.made, 4);
}

// An engine that takes other balls goes on for another solvent radius, but not for other choices.
TEST(EngineCache, OneEngineTakesAllSolventRadii) {
  FakeEngineLog log;
  log.takes = true;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  for (const double solvent : {0.0, 1.4, 0.0, 2.0}) {
    const EngineAnswer answer = cache.compute(balls, with_solvent_radius(solvent), {});
    const std::int64_t weight = answer.balls->weight(0);
    EXPECT_EQ(answer.balls->radii.at(0), 1700 + std::lround(1000 * solvent));
    EXPECT_EQ(answer.complex.vertices.alpha_values.at(0), static_cast<float>(-weight));
  }
  EXPECT_EQ(log.made, 1);
  Request other = with_solvent_radius(2);
  other.threads = 1;
  cache.compute(balls, other, {});
  EXPECT_EQ(log.made, 2);
  cache.compute(few_balls(5), with_solvent_radius(2), {});
  EXPECT_EQ(log.made, 3) << "another molecule";
}

EngineFactory cgal_factory() {
  return [](EngineChoice, std::shared_ptr<const BallSet> balls, const EngineSettings& settings) {
    return MadeEngine{make_cgal_engine(std::move(balls), {settings.threads}), ""};
  };
}

TEST(EngineCache, HandsOverWhatItsEnginesMakeOfAllBalls) {
  EngineCache cache(cgal_factory());
  EXPECT_FALSE(cache.take_made()) << "nothing was asked";
  const auto balls = few_balls(9);
  Request request;
  cache.compute(balls, request, {});
  EXPECT_GT(cache.kept_bytes(), 0u);
  ResultsForAllAlphas made = cache.take_made();
  ASSERT_TRUE(made.triangulation);
  ASSERT_TRUE(made.filtration);
  EXPECT_EQ(made.balls, balls);
  EXPECT_EQ(&made.filtration->balls(), balls.get());
  EXPECT_EQ(cache.kept_bytes(), 0u) << "each object has one owner";

  // The next request comes before the new owner can show the result.
  request.alpha_angstrom2 = 2;
  EXPECT_EQ(cache.compute(balls, request, {}).complex.engine.route, kThresholdRoute);
  EXPECT_FALSE(cache.take_made()) << "it is no other one";
  EXPECT_EQ(made.filtration.use_count(), 1);

  made = {};  // its owner had no room for it
  request.alpha_angstrom2 = 3;
  EXPECT_EQ(cache.compute(balls, request, {}).complex.engine.route,
            "regular triangulation, filtration, then threshold");
}

TEST(EngineCache, AnswersFromWhatTheOwnerHas) {
  EngineCache of_another(cgal_factory()), cache(cgal_factory());
  const auto balls = few_balls(9);
  Request request = with_solvent_radius(1.4);
  of_another.compute(balls, request, {});
  const ResultsForAllAlphas owned = of_another.take_made();
  const EngineAnswer answer = cache.compute(balls, request, {}, owned);
  EXPECT_EQ(answer.complex.engine.route, kThresholdRoute);
  EXPECT_EQ(answer.balls, owned.balls) << "equal balls are one object";
  EXPECT_EQ(cache.kept_bytes(), 0u);
  EXPECT_FALSE(cache.take_made());

  request.solvent_radius_angstrom = 1;
  EXPECT_NE(cache.compute(balls, request, {}, owned).complex.engine.route, kThresholdRoute)
      << "of other balls";
  EXPECT_TRUE(cache.take_made());
}

TEST(EngineCache, KeepsWhatNobodyElseHasUseFor) {
  EngineCache cache(cgal_factory());
  const auto balls = few_balls(9);
  cache.compute(balls, {}, {});
  const std::uint64_t kept = cache.kept_bytes();
  EXPECT_GT(kept, 0u);
  EXPECT_EQ(cache.compute(balls, {}, {}).complex.engine.route, kThresholdRoute);
  EXPECT_EQ(cache.kept_bytes(), kept);
}

TEST(EngineCache, KeepsWhatACancelledAnswerHadMade) {
  EngineCache cache(cgal_factory());
  const auto balls = few_balls(9);
  RunContext context;
  context.progress = [&](std::string_view stage, double) {
    if (stage == stage::kClassification) context.cancel.cancel();
  };
  EXPECT_THROW(cache.compute(balls, {}, context), Cancelled);
  const EngineAnswer answer = cache.compute(balls, {}, {});
  EXPECT_EQ(answer.complex.engine.route, "filtration of the whole triangulation, then threshold");
  EXPECT_TRUE(answer.cold);
}

TEST(EngineCache, CancellingKeepsNothingThatOthersOwn) {
  EngineCache of_another(cgal_factory()), cache(cgal_factory());
  const auto balls = few_balls(9);
  of_another.compute(balls, {}, {});
  const ResultsForAllAlphas owned = of_another.take_made();
  RunContext context;
  context.progress = [&](std::string_view, double) { context.cancel.cancel(); };
  EXPECT_THROW(cache.compute(balls, {}, context, owned), Cancelled);
  EXPECT_EQ(cache.kept_bytes(), 0u);
  EXPECT_EQ(owned.filtration.use_count(), 1);
}

TEST(EngineCache, SmallerAlphasAreThresholdsOfAnAnswerThatIsShared) {
  EngineCache cache(
      [](EngineChoice, std::shared_ptr<const BallSet> balls, const EngineSettings& settings) {
        return MadeEngine{make_cpu_engine(std::move(balls), {settings.threads}), ""};
      });
  const auto balls = few_balls(9);
  const auto answer_at = [&](double alpha, std::shared_ptr<const BallSet> of) {
    Request request;
    request.alpha_angstrom2 = alpha;
    return std::make_shared<const EngineAnswer>(cache.compute(of, request, {}));
  };
  auto first = answer_at(2, balls);
  cache.share(first);
  EXPECT_EQ(first.use_count(), 2) << "not copied";
  EXPECT_EQ(cache.kept_bytes(), bytes_of(first->complex));
  EXPECT_EQ(answer_at(1, balls)->complex.engine.route,
            "filtration of cached complex, then threshold");
  EXPECT_EQ(answer_at(0, balls)->complex.engine.route, "threshold of cached filtration");
  answer_at(3, balls);
  EXPECT_EQ(first.use_count(), 1) << "nobody needs it any more";
  answer_at(0, few_balls(8));
  cache.share(first);
  EXPECT_EQ(first.use_count(), 1) << "of other balls";
}

// The sphere of one ball of 1.7 Å.
constexpr double kSphereAngstrom2 = 36.316811075498;

TEST(EngineCache, MeasuresByTheDeviceOfItsEngine) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const EngineAnswer answer = cache.compute(few_balls(1), Request{}, {});
  EXPECT_FALSE(cache.measure_on_device(answer, {})) << "it has none";
  const MeasuredUnion on_cpu = cache.measure(answer, {});
  EXPECT_NEAR(on_cpu.measures.area_angstrom2(), kSphereAngstrom2, 1e-9);
  EXPECT_EQ(on_cpu.device.find("CPU, "), 0u) << on_cpu.device;
  EXPECT_EQ(on_cpu.note, "");

  log.measuring = {"a device", "by a miracle", ""};
  const MeasuredUnion on_device = cache.measure(answer, {});
  EXPECT_EQ(on_device.measures.area_angstrom2(), 123);
  EXPECT_EQ(on_device.device, "a device");
  EXPECT_EQ(on_device.route, "by a miracle");
  UnionDerivatives derivatives;
  EXPECT_EQ(cache.measure(answer, {}, &derivatives).device, on_cpu.device) << "no device has them";
  EXPECT_EQ(derivatives.area_by_radius_angstrom.size(), 1u);

  log.measuring = {"", "", "it is tired"};
  const MeasuredUnion instead = cache.measure(answer, {});
  EXPECT_NEAR(instead.measures.area_angstrom2(), kSphereAngstrom2, 1e-9);
  EXPECT_EQ(instead.device, on_cpu.device);
  EXPECT_EQ(instead.note, "Areas and volumes were computed on the CPU: it is tired.");
}

TEST(EngineCache, MeasuresOfOtherBallsAreNotLeftToTheDevice) {
  FakeEngineLog log;
  log.measuring = {"a device", "", ""};
  EngineCache cache(fake_factory(log));
  const EngineAnswer first = cache.compute(few_balls(1), Request{}, {});
  cache.compute(few_balls(3), Request{}, {});
  EXPECT_NEAR(cache.measure(first, {}).measures.area_angstrom2(), kSphereAngstrom2, 1e-9);
  EXPECT_EQ(log.measured, 0);
}

TEST(EngineCache, EnginesOfOneNumberOfThreadsShareThem) {
  FakeEngineLog log;
  std::vector<std::shared_ptr<WorkThreads>> given;
  const auto shared = std::make_shared<SharedThreads>();
  const EngineFactory make = fake_factory(log);
  EngineCache cache(
      [&](EngineChoice choice, std::shared_ptr<const BallSet> balls, const EngineSettings& s) {
        given.push_back(s.shared);
        return make(choice, std::move(balls), s);
      },
      shared);
  const auto balls = few_balls(4);
  Request request;
  request.threads = 2;
  cache.compute(balls, request, {});
  request.solvent_radius_angstrom = 1;
  cache.compute(balls, request, {});
  request.threads = 3;
  cache.compute(balls, request, {});
  ASSERT_EQ(given.size(), 3u);
  EXPECT_EQ(given[0], shared->of(2));
  EXPECT_EQ(given[1], given[0]);
  EXPECT_EQ(given[2], shared->of(3));
}

TEST(EngineCache, LetsTheEnginesThatAreNotAskedRest) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  Request request;
  request.engine = EngineChoice::gpu;
  cache.compute(balls, request, {});
  cache.compute(balls, request, {});
  EXPECT_EQ(log.rested, 0);
  request.engine = EngineChoice::cpu;
  cache.compute(balls, request, {});
  EXPECT_EQ(log.rested, 1);
}

TEST(EngineCache, LetsAllEnginesRestWhereNothingWillBeAsked) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  Request request;
  cache.release_memory();  // no engine
  request.engine = EngineChoice::gpu;
  cache.compute(balls, request, {});
  request.engine = EngineChoice::cpu;
  cache.compute(balls, request, {});
  log.rested = 0;
  cache.release_memory();
  EXPECT_EQ(log.rested, 2);
  EXPECT_EQ(cache.compute(balls, request, {}).complex.vertices.size(), 4u);
}

TEST(EngineCache, SaysHowLongTheDeviceLookedForTheOutside) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  EngineAnswer answer = cache.compute(few_balls(4), {}, {});
  cache.find_outer_faces_on_device(answer);  // there is no device
  EXPECT_FALSE(answer.complex.outside);
  EXPECT_EQ(answer.outer_faces_milliseconds, 0);
  log.finds_outside = true;
  cache.find_outer_faces_on_device(answer);
  EXPECT_TRUE(answer.complex.outside);
  EXPECT_GE(answer.outer_faces_milliseconds, 1);
}

TEST(EngineCache, SaysWhatTheLatticeRounds) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  Request request = with_solvent_radius(0.0004);
  request.alpha_angstrom2 = 1.4;
  const EngineAnswer finer = cache.compute(few_balls(4), request, {});
  EXPECT_EQ(finer.balls->lattice.digits, 4);
  EXPECT_EQ(finer.note, "");

  BallSet far = *few_balls(4);
  far.lattice.digits = 0;
  far.centres[0].x = kMaxLatticeCoordinate;
  request.solvent_radius_angstrom = 1.4;
  const std::string note = cache.compute(std::make_shared<BallSet>(far), request, {}).note;
  EXPECT_NE(note.find("solvent radius of 1.4 Å is rounded to 1 Å"), std::string::npos) << note;
  EXPECT_EQ(note.find("Alpha"), std::string::npos) << note;  // alpha is exact
  EXPECT_EQ(solvent_rounding_angstrom(request, far.lattice), 0.4);
  request.solvent_radius_angstrom = 2;
  request.alpha_angstrom2 = 3;
  EXPECT_EQ(cache.compute(std::make_shared<BallSet>(far), request, {}).note, "");
}

// Even a small rounding is reported, because the computed radius is not the requested one.
TEST(EngineCache, SaysASolventRadiusThatIsRoundedByLessThanAThousandth) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  BallSet far = *few_balls(4);
  far.centres[0].x = kMaxLatticeCoordinate;  // so the finest lattice is 0.001 Å
  for (const auto& [asked, used] : {std::pair{1.4004, "1.4"}, {1.400001, "1.4"}, {0.9999, "1"}}) {
    const Request request = with_solvent_radius(asked);
    const std::string note = cache.compute(std::make_shared<BallSet>(far), request, {}).note;
    EXPECT_NE(note.find(" is rounded to " + std::string(used) + " Å: "), std::string::npos)
        << asked << ": " << note;
  }
  EXPECT_EQ(cache.compute(std::make_shared<BallSet>(far), with_solvent_radius(1.401), {}).note, "");
  EXPECT_EQ(solvent_rounding_angstrom(with_solvent_radius(1.4004), far.lattice), 0.0004);
}

TEST(EngineCache, TellsEnginesApartByTheirSwitches) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  Request request;
  request.engine = EngineChoice::tuples_cpu;
  cache.compute(balls, request, {});
  cache.compute(balls, request, {});
  EXPECT_EQ(log.made, 1);
  request.tuples.edge_optimisation = false;
  cache.compute(balls, request, {});
  EXPECT_EQ(log.made, 2);
}

TEST(EngineCache, FreesTheEnginesOfAnotherMolecule) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  auto first = few_balls(4);
  const std::weak_ptr<const BallSet> watch = first;
  cache.compute(first, {}, {});
  first.reset();
  EXPECT_FALSE(watch.expired());
  cache.compute(few_balls(5), {}, {});
  EXPECT_TRUE(watch.expired());
}

// The engine alone decides what replaces a failing device (core/engines/engine_of_executors.hpp).
TEST(EngineCache, AFailingDeviceIsTheEnginesBusinessWhateverTheChoice) {
  struct LostDevice : Executor {
    std::optional<AlphaComplex> compute(const AlphaRequest&, const RunContext&) override {
      throw ExecutorFailed("the device is lost");
    }
  };
  int made = 0;
  EngineCache cache([&](EngineChoice, std::shared_ptr<const BallSet> balls, const EngineSettings&) {
    ++made;
    return MadeEngine{make_engine_of_executors(std::move(balls), {1},
                                               [](auto) { return std::make_unique<LostDevice>(); }),
                      ""};
  });
  const auto balls = few_balls(4);
  for (const EngineChoice choice : {EngineChoice::automatic, EngineChoice::gpu}) {
    Request request;
    request.engine = choice;
    for (int again = 0; again < 2; ++again) {
      const EngineAnswer result = cache.compute(balls, request, {});
      EXPECT_EQ(result.complex.vertices.size(), 4u);
      const std::string& route = result.complex.engine.route;
      EXPECT_NE(route.find("(on the CPU: the device is lost)"), std::string::npos) << route;
    }
  }
  EXPECT_EQ(made, 2) << "one engine a choice, which stays";
}

TEST(EngineCache, WhatAnEngineThrowsIsAnErrorAndLeavesItUsable) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  log.fail_next = true;
  EXPECT_THROW(cache.compute(balls, {}, {}), std::runtime_error);
  EXPECT_EQ(cache.compute(balls, {}, {}).complex.vertices.size(), 4u);
  EXPECT_EQ(log.made, 1) << "no other engine was put in its place";
}

TEST(EngineCache, ABadSolventRadiusLeavesItUsable) {
  FakeEngineLog log;
  EngineCache cache(fake_factory(log));
  const auto balls = few_balls(4);
  EXPECT_THROW(cache.compute(balls, with_solvent_radius(-1), {}), std::invalid_argument);
  EXPECT_EQ(cache.compute(balls, with_solvent_radius(0), {}).complex.vertices.size(), 4u);
}

}  // namespace
}  // namespace alphascope
