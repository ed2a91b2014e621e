// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the thesis' suite with engines of known speed, and once with the real ones.
#include "app/bench/thesis_suite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "app/bench/thesis_contest.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "tests/app/session/fake_engine.hpp"

namespace alphascope {
namespace {

using Kind = ThesisRow::Kind;

// An engine that sleeps for a given time, unless its token is cancelled. The test knows its stages
// and its hash. It counts its requests in `started`, if that is given.
class SleepingEngine : public Engine {
 public:
  SleepingEngine(double milliseconds, std::uint64_t hash, std::size_t tetrahedra,
                 std::atomic<int>* started = nullptr)
      : milliseconds_(milliseconds), hash_(hash), tetrahedra_(tetrahedra), started_(started) {}
  AlphaComplex compute(const AlphaRequest&, KnownResults&, const RunContext& context) override {
    if (started_ != nullptr) {
      ++*started_;
      started_->notify_all();
    }
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(milliseconds_);
    while (std::chrono::steady_clock::now() < end) {
      context.cancel.throw_if_cancelled();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    AlphaComplex complex;
    complex.tetrahedra_only = true;
    complex.tetrahedra.simplices.resize(tetrahedra_);
    complex.hash = hash_;
    complex.timings.stages = {{std::string(stage::kCoincident), 0.25, true},
                              {std::string(stage::kHostToDevice), 1, false},
                              {std::string(stage::kCandidates), 2, false},
                              {std::string(stage::kPrefixSum), 3, false},
                              {std::string(stage::kFilteredValidity), 4, false},
                              {std::string(stage::kExactValidity), 5, false},
                              {std::string(stage::kDeviceToHost), 6, false}};
    complex.engine.counters = {{"4-tuples", 7}};
    return complex;
  }

 private:
  double milliseconds_;
  std::uint64_t hash_;
  std::size_t tetrahedra_;
  std::atomic<int>* started_;
};

struct Speeds {
  double cgal = 40, cpu = 10, tuples = 10;  // ms
  double without_edges = 10;
  std::uint64_t cpu_hash = 1;
  std::atomic<int>* cpu_started = nullptr;
};

EngineFactory sleeping_factory(Speeds s) {
  return [s](EngineChoice choice, std::shared_ptr<const BallSet>, const EngineSettings& settings) {
    MadeEngine made;
    double ms = choice == EngineChoice::cgal ? s.cgal : s.cpu;
    if (is_tuple_engine(choice))
      ms = settings.tuples.edge_optimisation ? s.tuples : s.without_edges;
    const bool cpu = choice == EngineChoice::cpu;
    made.engine = std::make_unique<SleepingEngine>(ms, cpu ? s.cpu_hash : 1, 20,
                                                   cpu ? s.cpu_started : nullptr);
    return made;
  };
}

ThesisOptions quick_options() {
  ThesisOptions options;
  options.alphas = {0};
  options.engines = {EngineChoice::cpu};
  options.threads = 1;
  options.repeats = 3;
  options.seconds_per_row = 5;
  options.bisections = 0;
  return options;
}

std::vector<ThesisMolecule> one_molecule() {
  return {{"few", test::few_balls(12), {{"file", "few.xyzr"}}}};
}

const ThesisRow& find(const ThesisReport& report, Kind kind, EngineChoice choice,
                      const std::string& variant = {}) {
  const auto it = std::find_if(report.rows.begin(), report.rows.end(), [&](const ThesisRow& row) {
    return row.kind == kind && row.choice == choice && (variant.empty() || row.variant == variant);
  });
  if (it == report.rows.end()) throw std::runtime_error("no such row");
  return *it;
}

TEST(ThesisSuite, KnownTimesGiveKnownSpeedUpAndColumns) {
  const ThesisReport report =
      run_thesis_suite(one_molecule(), quick_options(), sleeping_factory({}), {});
  ASSERT_EQ(report.rows.size(), 2u);
  const ThesisRow& row = find(report, Kind::engine, EngineChoice::cpu);
  EXPECT_EQ(row.runs, 3);
  EXPECT_GE(row.cold_milliseconds, 10);
  EXPECT_GE(*row.cgal_cold_milliseconds, 40);
  EXPECT_DOUBLE_EQ(*row.speed_up(), *row.cgal_cold_milliseconds / row.cold_milliseconds);
  EXPECT_GT(*row.speed_up(), 1.5);
  EXPECT_LT(*row.speed_up(), 4.5);
  EXPECT_EQ(row.stages.memcpy, 7);
  EXPECT_EQ(row.stages.kernel1, 2);
  EXPECT_EQ(row.stages.prefix_sum, 3);
  EXPECT_EQ(row.stages.kernel2, 4);
  EXPECT_EQ(row.stages.kernel3, 5);
  EXPECT_EQ(row.stages.other, 0.25);
  EXPECT_FALSE(row.stages.kernel1_has_kernel2);
  EXPECT_EQ(row.same_as_cgal, true);
  EXPECT_DOUBLE_EQ(*row.share_of_full(), 1.0);
  EXPECT_EQ(row.engine.counters.at(0).value, 7u);
  EXPECT_TRUE(report.all_same());
  EXPECT_FALSE(report.machine.cpu.empty());
  EXPECT_FALSE(report.program.empty());
}

TEST(ThesisSuite, ADifferentResultIsToldInItsRow) {
  Speeds speeds;
  speeds.cpu_hash = 2;
  const ThesisReport report =
      run_thesis_suite(one_molecule(), quick_options(), sleeping_factory(speeds), {});
  EXPECT_EQ(find(report, Kind::engine, EngineChoice::cpu).same_as_cgal, false);
  EXPECT_FALSE(report.all_same());
}

TEST(ThesisSuite, WhatTakesTooLongIsSkippedWithTheReasonHereAndAtLargerAlphas) {
  ThesisOptions options = quick_options();
  options.alphas = {1, 0};  // the suite sorts them
  options.engines = {EngineChoice::tuples_cpu, EngineChoice::cpu};
  options.seconds_per_row = 0.4;
  options.ablation = false;
  Speeds speeds;
  speeds.tuples = 60000;
  const auto start = std::chrono::steady_clock::now();
  const ThesisReport report =
      run_thesis_suite(one_molecule(), options, sleeping_factory(speeds), {});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  std::vector<std::string> skipped;
  for (const ThesisRow& row : report.rows) {
    if (row.choice != EngineChoice::tuples_cpu) continue;
    skipped.push_back(row.skipped);
    EXPECT_FALSE(row.measured());
    EXPECT_FALSE(row.speed_up());
    EXPECT_FALSE(row.same_as_cgal);
  }
  EXPECT_EQ(skipped, (std::vector<std::string>{"over 0.4 s", "over 0.4 s at α = 0 Å² already"}));
  EXPECT_TRUE(find(report, Kind::engine, EngineChoice::cpu).measured());
  const BreakEven& lost = report.break_even.at(0);
  EXPECT_FALSE(lost.alpha_angstrom2);
  EXPECT_EQ(lost.lost_at_angstrom2, 0);
}

TEST(ThesisSuite, AblationRowsSwitchOneOptimisationOffEach) {
  ThesisOptions options = quick_options();
  options.engines = {EngineChoice::tuples_cpu};
  Speeds speeds;
  speeds.without_edges = 50;
  const ThesisReport report =
      run_thesis_suite(one_molecule(), options, sleeping_factory(speeds), {});
  const double whole = find(report, Kind::engine, EngineChoice::tuples_cpu).cold_milliseconds;
  const auto without = [&](const char* variant) {
    return find(report, Kind::ablation, EngineChoice::tuples_cpu, variant).cold_milliseconds;
  };
  EXPECT_GE(without("without edge optimisation"), 50);
  EXPECT_GT(without("without edge optimisation"), whole);
  EXPECT_GT(without("without alpha optimisation"), 0);
  EXPECT_THROW(without("without textures"), std::runtime_error) << "says nothing on the CPU";
}

TEST(ThesisSuite, BisectionNarrowsTheAlphaUpToWhichCgalIsBeaten) {
  // Our engine takes 10 ms up to alpha 1 and 90 ms from there on. CGAL takes 40 ms.
  class Growing : public Engine {
   public:
    AlphaComplex compute(const AlphaRequest& request, KnownResults& known,
                         const RunContext& context) override {
      return SleepingEngine(request.alpha_angstrom2 <= 1.0 ? 10 : 90, 1, 20)
          .compute(request, known, context);
    }
  };
  const EngineFactory sleeping = sleeping_factory({});
  const EngineFactory factory = [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                                    const EngineSettings& settings) {
    MadeEngine made = sleeping(choice, balls, settings);
    if (choice == EngineChoice::cpu) made.engine = std::make_unique<Growing>();
    return made;
  };
  ThesisOptions options = quick_options();
  options.alphas = {0, 4};
  options.bisections = 3;
  options.repeats = 1;
  const ThesisReport report = run_thesis_suite(one_molecule(), options, factory, {});
  const BreakEven& found = report.break_even.at(0);
  EXPECT_FALSE(found.beyond);
  EXPECT_EQ(found.alpha_angstrom2, 1.0);
  EXPECT_EQ(found.lost_at_angstrom2, 1.5);
}

TEST(ThesisSuite, CancellingEndsItSoonAndProgressIsTold) {
  RunContext context;
  std::vector<std::string> told;
  context.progress = [&](std::string_view what, double) { told.emplace_back(what); };
  Speeds speeds;
  speeds.cpu = 60000;
  ThesisOptions options = quick_options();
  options.seconds_per_row = 50;
  std::atomic<int> started = 0;
  speeds.cpu_started = &started;
  std::thread killer([cancel = context.cancel, &started] {
    started.wait(0);  // in the middle of a computation that takes a minute
    cancel.cancel();
  });
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(run_thesis_suite(one_molecule(), options, sleeping_factory(speeds), context),
               Cancelled);
  EXPECT_GT(started.exchange(1), 0);
  started.notify_all();  // so the waiting thread always ends
  killer.join();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.front(), "few, whole triangulation");
}

TEST(ThesisSuite, ProgressGrowsOverAllMoleculesAndStaysBelowOne) {
  RunContext context;
  std::vector<double> shares;
  context.progress = [&](std::string_view what, double share) {
    if (what.find(", ") != std::string_view::npos) shares.push_back(share);
  };
  std::vector<ThesisMolecule> three;
  for (int k = 0; k < 3; ++k) three.push_back(one_molecule().front());
  Speeds speeds;
  speeds.cgal = speeds.cpu = 1;
  run_thesis_suite(three, quick_options(), sleeping_factory(speeds), context);
  ASSERT_GE(shares.size(), 3u);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.back(), 2.0 / 3);
  EXPECT_LE(shares.back(), 1);
}

TEST(ThesisSuite, AnEngineThatFailsGivesASkippedRowWithItsMessage) {
  const EngineFactory sleeping = sleeping_factory({});
  const EngineFactory factory = [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                                    const EngineSettings& settings) {
    if (choice == EngineChoice::cpu) throw EngineUnavailable("no such device");
    return sleeping(choice, balls, settings);
  };
  const ThesisReport report = run_thesis_suite(one_molecule(), quick_options(), factory, {});
  EXPECT_EQ(find(report, Kind::engine, EngineChoice::cpu).skipped, "no such device");
  EXPECT_TRUE(report.break_even.empty()) << "nothing is known of an engine that failed";
}

TEST(ThesisSuite, SenselessOptionsAreRefused) {
  ThesisOptions options = quick_options();
  const EngineFactory factory = sleeping_factory({});
  EXPECT_THROW(run_thesis_suite({}, options, factory, {}), std::invalid_argument);
  options.alphas = {NAN};
  EXPECT_THROW(run_thesis_suite(one_molecule(), options, factory, {}), std::invalid_argument);
  options = quick_options();
  options.engines = {EngineChoice::cgal};
  EXPECT_THROW(run_thesis_suite(one_molecule(), options, factory, {}), std::invalid_argument);
}

TEST(ThesisSuite, TheRealEnginesAgree) {
  ThesisOptions options = quick_options();
  options.engines = {EngineChoice::tuples_cpu, EngineChoice::cpu};
  options.alphas = {0, 1.4};
  const ThesisReport report = run_thesis_suite(one_molecule(), options, make_engine, {});
  EXPECT_TRUE(report.all_same());
  for (const ThesisRow& row : report.rows) {
    EXPECT_TRUE(row.measured()) << row.skipped;
    EXPECT_EQ(row.same_as_cgal, true) << engine_id(row.choice) << row.variant;
  }
  EXPECT_TRUE(find(report, Kind::engine, EngineChoice::tuples_cpu).stages.kernel1);
  EXPECT_FALSE(find(report, Kind::cgal, EngineChoice::cgal).stages.kernel1);
}

}  // namespace
}  // namespace alphascope
