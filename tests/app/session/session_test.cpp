// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the session as a window uses it. Calls never wait, the latest request wins, and a failure
// keeps the previous molecule and results.
#include "app/session/session.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "core/geometry/lattice_alpha.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/triangulation/filtration.hpp"
#include "tests/app/session/fake_engine.hpp"
#include "tests/support/dimer.hpp"
#include "ui/panels/view_info.hpp"

namespace alphascope {
namespace {

using test::fake_factory;
using test::FakeEngineLog;

class SessionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern =
        (std::filesystem::path(::testing::TempDir()) / "alphascope_session_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());  // tests run side by side, each in its own process
    good_ = write("good.xyzr", "0 0 0 1.7\n1.5 0 0 1.7\n0 1.5 0 1.5\n0 0 1.5 1.2\n");
    other_ = write("other.xyzr", "0 0 0 1.7\n2 0 0 1.7\n");
    bad_ = write("bad.xyzr", "0 0 0 1.7\n1 2 banana 1.7\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::path path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }

  std::unique_ptr<Session> make() {
    Session::Services services = Session::program_services();
    services.make_engine = fake_factory(log_);
    return std::make_unique<Session>(std::function<void()>{}, services);
  }

  static SessionChanges settle(Session& session) {
    SessionChanges all;
    for (bool busy = true; busy;) {
      const SessionActivity activity = session.activity();
      busy = activity.opening.busy || activity.computing.busy || activity.comparing.busy;
      const SessionChanges changes = session.poll();
      all.molecule |= changes.molecule;
      all.answer |= changes.answer;
      all.agreement |= changes.agreement;
      all.error |= changes.error;
      all.options |= changes.options;
      busy |= changes.any();
      std::this_thread::yield();
    }
    return all;
  }

  // Waits without polling, so results that arrive stay undelivered.
  template <class Condition>
  static bool wait_for(const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::yield();
    }
    return true;
  }

  // False when the condition is not true within a time that suffices on any machine.
  template <class Condition>
  static bool poll_until(Session& session, const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      session.poll();
      std::this_thread::yield();
    }
    return true;
  }

  static Request alpha(double value) {
    Request request;
    request.alpha_angstrom2 = value;
    return request;
  }

  FakeEngineLog log_;
  std::filesystem::path folder_, good_, other_, bad_;
};

TEST_F(SessionTest, OpensAndComputesAtThePresentRequest) {
  const auto session = make();
  session->set_request(alpha(1.4));
  EXPECT_FALSE(session->state().molecule);
  session->open(good_);
  const SessionChanges changes = settle(*session);
  EXPECT_TRUE(changes.molecule);
  EXPECT_TRUE(changes.answer);
  EXPECT_FALSE(changes.error);
  const SessionState& state = session->state();
  ASSERT_TRUE(state.molecule && state.prepared && state.ours);
  EXPECT_EQ(state.molecule->atoms.size(), 4u);
  EXPECT_TRUE(state.up_to_date());
  EXPECT_DOUBLE_EQ(state.ours->complex.alpha_angstrom2(), 1.4);
  EXPECT_TRUE(state.our_timings.cold);
  EXPECT_FALSE(state.our_timings.warm);
}

// Answer and file have both arrived when the window polls. The answer is of the earlier molecule,
// and the file is taken first.
TEST_F(SessionTest, AnAnswerThatComesWithAnotherFileIsNotShownOnIt) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->set_request(alpha(2));
  ASSERT_TRUE(wait_for([&] { return session->activity().computing.undelivered; }));
  log_.hold = true;
  session->open(other_);
  ASSERT_TRUE(wait_for([&] { return session->activity().opening.undelivered; }));
  EXPECT_TRUE(session->poll().molecule);
  EXPECT_EQ(session->state().molecule->atoms.size(), 2u);
  EXPECT_FALSE(session->state().ours);
  EXPECT_FALSE(session->state().agreement);
  EXPECT_FALSE(session->state().our_timings.warm) << "of the molecule before";
  log_.hold = false;
  settle(*session);
  ASSERT_TRUE(session->state().ours);
  EXPECT_EQ(session->state().ours->complex.vertices.size(), 2u);
}

// A running computation of the earlier molecule is cancelled, even during a drag, in which
// computations are otherwise finished.
TEST_F(SessionTest, AnotherFileCancelsWhatIsComputedForTheOldOne) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->set_request(alpha(2));
  settle(*session);
  EXPECT_TRUE(session->state().our_timings.warm);
  session->set_dragging(true);
  log_.hold = true;
  const int before = log_.started;
  session->set_request(alpha(3));
  ASSERT_TRUE(wait_for([&] { return log_.started > before; }));
  session->open(other_);
  ASSERT_TRUE(poll_until(*session, [&] { return session->state().molecule->atoms.size() == 2; }));
  EXPECT_FALSE(session->state().our_timings.cold) << "of the molecule before";
  EXPECT_FALSE(session->state().our_timings.warm);
  EXPECT_TRUE(poll_until(*session, [&] { return log_.cancelled == 1; }));
  log_.hold = false;
  settle(*session);
  ASSERT_TRUE(session->state().ours);
  EXPECT_EQ(session->state().ours->complex.vertices.size(), 2u);
}

TEST_F(SessionTest, AComparisonThatComesWithAnotherFileIsNotShownOnIt) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->request_comparison();
  ASSERT_TRUE(wait_for([&] { return session->activity().comparing.undelivered; }));
  log_.hold = true;
  session->open(other_);
  ASSERT_TRUE(wait_for([&] { return session->activity().opening.undelivered; }));
  EXPECT_TRUE(session->poll().molecule);
  EXPECT_FALSE(session->state().ours);
  EXPECT_FALSE(session->state().agreement);
  EXPECT_FALSE(session->state().reference_timings.cold) << "of the molecule before";
  log_.hold = false;
  settle(*session);
  EXPECT_FALSE(session->state().agreement);
}

TEST_F(SessionTest, ColdAndWarmTimesAreKeptApart) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->set_request(alpha(2));
  settle(*session);
  EXPECT_TRUE(session->state().our_timings.cold);
  EXPECT_TRUE(session->state().our_timings.warm);
  Request grown = alpha(2);
  grown.solvent_radius_angstrom = 1.4;
  session->set_request(grown);
  settle(*session);
  EXPECT_FALSE(session->state().our_timings.warm) << "another set of balls";
}

TEST_F(SessionTest, OtherRadiiWaitForTablesOnTheDevice) {
  std::atomic<int> waits{0};
  Session::Services services = Session::program_services();
  services.make_engine = fake_factory(log_);
  services.wait_for_device = [&](const CancelToken&) { ++waits; };
  Session session({}, services);
  session.open(good_);
  settle(session);
  Request grown = alpha(1);
  grown.solvent_radius_angstrom = 1.4;
  session.set_request(grown);
  settle(session);
  EXPECT_EQ(waits, 0) << "no tables are being made";
  session.set_tables_first(true);
  grown.alpha_angstrom2 = 2;
  session.set_request(grown);
  settle(session);
  EXPECT_EQ(waits, 0) << "the tables are of the same balls";
  grown.solvent_radius_angstrom = 1.5;
  session.set_request(grown);
  settle(session);
  EXPECT_EQ(waits, 1);
  EXPECT_TRUE(session.state().up_to_date());
}

TEST_F(SessionTest, AnswersBringMeasuresWhenTheyAreWantedAndADeviceHasThem) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->set_measuring(true);
  session->set_request(alpha(1));
  settle(*session);
  EXPECT_FALSE(session->state().ours->measures) << "this engine has no device";
  log_.measuring = {"a device", "", ""};
  session->set_request(alpha(2));
  settle(*session);
  ASSERT_TRUE(session->state().ours->measures);
  EXPECT_EQ(session->state().ours->measures->device, "a device");
  session->set_measuring(false);
  session->set_request(alpha(3));
  settle(*session);
  EXPECT_FALSE(session->state().ours->measures);
}

TEST_F(SessionTest, OnlyTheFirstAnswerIsCold) {
  const auto session = make();
  session->set_request(alpha(3));
  session->open(good_);
  settle(*session);
  log_.set_up_again = true;  // like engines that prepare for later answers
  session->set_request(alpha(1));
  settle(*session);
  const ColdAndWarm& ours = session->state().our_timings;
  ASSERT_TRUE(ours.cold && ours.warm);
  EXPECT_DOUBLE_EQ(ours.cold->alpha_angstrom2, 3);
  EXPECT_DOUBLE_EQ(ours.warm->alpha_angstrom2, 1);
}

TEST_F(SessionTest, ComputingAnewGivesTheColdTimeOfAnEngineThatWasKept) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->request_comparison();
  settle(*session);
  const Request first = session->state().request;
  Request other = first;
  other.engine = EngineChoice::cpu;
  session->set_request(other);
  settle(*session);
  session->set_request(first);
  settle(*session);
  ASSERT_FALSE(session->state().our_timings.cold) << "the engine was kept";
  const auto before = session->state().ours;
  const int made = log_.made;
  session->compute_anew();
  settle(*session);
  EXPECT_TRUE(session->state().our_timings.cold);
  EXPECT_NE(session->state().ours, before) << "so that it is compared again";
  EXPECT_EQ(log_.made, made + 1);
  session->request_comparison();
  settle(*session);
  EXPECT_EQ(log_.made, made + 2) << "CGAL triangulates anew";
  EXPECT_TRUE(session->state().reference_timings.cold);
  session->set_request(alpha(2));
  settle(*session);
  session->request_comparison();
  settle(*session);
  EXPECT_EQ(log_.made, made + 2) << "once only";
}

TEST_F(SessionTest, ComputingAnewWithoutAMoleculeDoesNothing) {
  const auto session = make();
  session->compute_anew();
  settle(*session);
  EXPECT_EQ(log_.started, 0);
}

TEST_F(SessionTest, SwitchesOfTheTupleEngineLeaveCgalsTriangulation) {
  std::atomic<int> references{0};
  Session::Services services = Session::program_services();
  services.cgal_threads = 1;
  services.make_engine = [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                             const EngineSettings& settings) {
    if (choice == EngineChoice::cgal) ++references;
    return fake_factory(log_)(choice, balls, settings);
  };
  Session session({}, services);
  session.open(good_);
  settle(session);
  Request request = alpha(0);
  request.engine = EngineChoice::tuples_cpu;
  for (const bool edge_optimisation : {true, false}) {
    request.tuples.edge_optimisation = edge_optimisation;
    session.set_request(request);
    session.request_comparison();
    settle(session);
    ASSERT_TRUE(session.state().agreement);
  }
  EXPECT_EQ(references, 1);
}

TEST_F(SessionTest, AFailedOpenKeepsTheOldMolecule) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  const auto before = session->state();
  session->open(bad_);
  const SessionChanges changes = settle(*session);
  EXPECT_TRUE(changes.error);
  EXPECT_FALSE(changes.molecule);
  EXPECT_NE(session->state().last_error.find("bad.xyzr, line 2"), std::string::npos)
      << session->state().last_error;
  EXPECT_EQ(session->state().molecule, before.molecule);
  EXPECT_EQ(session->state().ours, before.ours);
  session->open(other_);
  settle(*session);
  EXPECT_TRUE(session->state().last_error.empty()) << "a later success clears it";
  EXPECT_EQ(session->state().prepared->balls->size(), 2u);
}

TEST_F(SessionTest, ASliderStormEndsAtTheLastAlpha) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  log_.steps = 20;
  for (int i = 1; i <= 1000; ++i) {
    session->set_request(alpha(i * 0.01));
    if (i % 3 == 0) session->poll();
  }
  settle(*session);
  EXPECT_TRUE(session->state().up_to_date());
  EXPECT_DOUBLE_EQ(session->state().ours->complex.alpha_angstrom2(), 10.0);
  EXPECT_LT(log_.started, 500) << "most requests are never started";
}

TEST_F(SessionTest, ALongComputationGivesWayToTheLatestRequest) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  log_.hold = true;
  const int started = log_.started;
  session->set_request(alpha(1));
  while (log_.started == started) std::this_thread::yield();
  session->set_request(alpha(2));
  while (log_.cancelled == 0) session->poll();
  log_.hold = false;
  settle(*session);
  EXPECT_DOUBLE_EQ(session->state().ours->complex.alpha_angstrom2(), 2.0);
  EXPECT_TRUE(session->state().last_error.empty());
}

TEST_F(SessionTest, CancelKeepsTheLastAnswer) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  const auto before = session->state().ours;
  log_.hold = true;
  session->set_request(alpha(5));
  session->cancel_computing();
  settle(*session);
  EXPECT_EQ(session->state().ours, before);
  EXPECT_FALSE(session->state().up_to_date());
  EXPECT_TRUE(session->state().last_error.empty());
  log_.hold = false;
  session->set_request(alpha(5));  // a repeated request without an answer still counts
  settle(*session);
  EXPECT_TRUE(session->state().up_to_date());
}

TEST_F(SessionTest, AFailedComputationIsReportedAndKeepsTheLastAnswer) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  const auto before = session->state().ours;
  log_.fail_next = true;
  session->set_request(alpha(3));
  settle(*session);
  EXPECT_EQ(session->state().ours, before);
  EXPECT_NE(session->state().last_error.find("broken on purpose"), std::string::npos);
  Request negative = alpha(3);
  negative.solvent_radius_angstrom = -1;
  session->set_request(negative);
  settle(*session);
  EXPECT_NE(session->state().last_error.find("solvent radius"), std::string::npos);
  session->set_request(alpha(3));
  settle(*session);
  EXPECT_TRUE(session->state().last_error.empty());
}

TEST_F(SessionTest, AnAnswerForTheOldMoleculeIsNeverShownWithTheNew) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  for (int round = 0; round < 30; ++round) {
    session->open(round % 2 ? good_ : other_);
    session->set_request(alpha(round));
    for (int i = 0; i < 20; ++i) {
      session->poll();
      const SessionState& state = session->state();
      if (state.ours) {
        EXPECT_EQ(state.ours->prepared, state.prepared);
        EXPECT_EQ(state.ours->complex.vertices.size(), state.prepared->balls->size());
      }
      std::this_thread::yield();
    }
  }
  settle(*session);
  EXPECT_TRUE(session->state().up_to_date());
}

TEST_F(SessionTest, ComparesTheAnswerThatIsOnItsWay) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->set_request(alpha(2));
  session->request_comparison();
  settle(*session);
  const SessionState& state = session->state();
  ASSERT_TRUE(state.agreement);
  EXPECT_EQ(state.agreement->ours, state.ours);
  EXPECT_DOUBLE_EQ(state.agreement->reference->alpha_angstrom2(), 2.0);
  EXPECT_TRUE(state.agreement->comparison.identical());
  EXPECT_EQ(state.agreement->comparison.vertices.common, 4u);
  EXPECT_TRUE(state.reference_timings.cold);
}

TEST_F(SessionTest, CgalIsTimedWithAllThreadsToo) {
  std::vector<int> threads;
  Session::Services services = Session::program_services();
  services.make_engine = [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                             const EngineSettings& settings) {
    if (choice == EngineChoice::cgal) threads.push_back(settings.threads);
    return fake_factory(log_)(choice, balls, settings);
  };
  for (const int available : {2, 4}) {
    threads.clear();
    services.cgal_threads = available;
    Session session({}, services);
    session.open(good_);
    settle(session);
    session.request_comparison();
    settle(session);
    const bool parallel = available >= 3;  // from here on CGAL works in parallel
    ASSERT_TRUE(poll_until(session, [&] {
      return session.state().agreement &&
             session.state().parallel_timings.cold.has_value() == parallel;
    }));
    EXPECT_EQ(threads, parallel ? (std::vector<int>{1, 4}) : std::vector<int>{1});
    Request other = alpha(0);
    other.solvent_radius_angstrom = 1.4;
    session.set_request(other);
    EXPECT_FALSE(session.state().parallel_timings.cold) << "of other balls";
    settle(session);
  }
}

TEST_F(SessionTest, AnotherSwitchOfTheTupleEngineForgetsItsTimes) {
  const auto session = make();
  session->open(good_);
  Request request = alpha(0);
  request.engine = EngineChoice::tuples_cpu;
  session->set_request(request);
  settle(*session);
  ASSERT_TRUE(session->state().our_timings.cold);
  request.tuples.edge_optimisation = false;
  session->set_request(request);
  EXPECT_FALSE(session->state().our_timings.cold);
  settle(*session);
  EXPECT_TRUE(session->state().our_timings.cold);
}

TEST_F(SessionTest, ASliderMovesWhileTheComparisonRuns) {
  FakeEngineLog slow;
  slow.hold = true;
  Session::Services services = Session::program_services();
  services.make_engine = [&](EngineChoice choice, std::shared_ptr<const BallSet> balls,
                             const EngineSettings& settings) {
    return fake_factory(choice == EngineChoice::cgal ? slow : log_)(choice, balls, settings);
  };
  Session session({}, services);
  session.open(good_);
  settle(session);
  session.request_comparison();
  // Polls like a window. An answer that is still on its way is compared when it arrives.
  ASSERT_TRUE(poll_until(session, [&] { return slow.started > 0; }));
  session.set_request(alpha(7));
  ASSERT_TRUE(poll_until(session, [&] { return session.state().up_to_date(); }));
  EXPECT_TRUE(session.activity().comparing.busy);
  session.cancel_comparison();
  settle(session);
  EXPECT_FALSE(session.state().agreement);
  EXPECT_EQ(slow.cancelled, 1);
}

TEST_F(SessionTest, OptionsChangeTheOpenMoleculeAndFailuresKeepIt) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  const auto molecule = session->state().molecule;
  const auto prepared = session->state().prepared;
  OpenOptions options;
  options.balls.radii = RadiiSet::bondi;
  session->set_open_options(options);
  EXPECT_FALSE(settle(*session).options);
  EXPECT_EQ(session->state().molecule, molecule) << "not read again";
  EXPECT_NE(session->state().prepared, prepared);
  EXPECT_EQ(session->state().ours->prepared, session->state().prepared);
  const auto ours = session->state().ours;
  OpenOptions wrong = options;
  wrong.balls.model = 17;
  session->set_open_options(wrong);
  const SessionChanges changes = settle(*session);
  EXPECT_FALSE(session->state().last_error.empty());
  EXPECT_EQ(session->state().ours, ours) << "the present result stays";
  EXPECT_TRUE(changes.options);
  EXPECT_EQ(session->open_options(), options) << "what was refused is taken back";
}

TEST_F(SessionTest, AnAssemblyIsExpandedFromTheDepositedAtomsAndTakenBack) {
  const std::filesystem::path dimer = write(
      "dimer.pdb",
      std::string(testing::kDimerRemark) +
          "ATOM      1  N   MET A   1       1.000   2.000   3.000  1.00  9.67           N  \n");
  const auto session = make();
  session->open(dimer);
  settle(*session);
  const auto deposited = session->state().molecule;
  ASSERT_EQ(session->state().opened->assemblies.size(), 1u);
  EXPECT_EQ(session->state().opened->assemblies[0].atoms, 2u);
  std::filesystem::remove(dimer);  // so that it cannot be read again

  OpenOptions options = session->open_options();
  options.assembly = "1";
  session->set_open_options(options);
  settle(*session);
  EXPECT_EQ(session->state().molecule->atoms.size(), 2u);
  EXPECT_EQ(session->state().opened->contents->chains.size(), 2u);
  EXPECT_EQ(session->state().opened->deposited, deposited);
  EXPECT_TRUE(session->state().up_to_date());

  options.assembly = "7";
  session->set_open_options(options);
  settle(*session);
  EXPECT_NE(session->state().last_error.find("no assembly 7"), std::string::npos);
  EXPECT_EQ(session->state().molecule->atoms.size(), 2u) << "the present molecule stays";
  EXPECT_EQ(session->open_options().assembly, "1");

  options.assembly.clear();
  session->set_open_options(options);
  settle(*session);
  EXPECT_EQ(session->state().molecule, deposited);
  EXPECT_TRUE(session->state().last_error.empty());
}

TEST_F(SessionTest, CancellingAnExpansionKeepsTheMoleculeAndTakesTheOptionsBack) {
  std::atomic<bool> expanding{false};
  Session::Services services = Session::program_services();
  services.make_engine = fake_factory(log_);
  services.reopen_molecule = [&](const OpenedMolecule&, const OpenOptions&,
                                 const RunContext& context) -> OpenedMolecule {
    expanding = true;
    for (;;) {
      context.cancel.throw_if_cancelled();
      std::this_thread::yield();
    }
  };
  Session session({}, services);
  session.open(good_);
  settle(session);
  const auto ours = session.state().ours;
  OpenOptions options = session.open_options();
  options.assembly = "1";
  session.set_open_options(options);
  ASSERT_TRUE(poll_until(session, [&] { return expanding.load(); }));
  EXPECT_EQ(session.state().ours, ours) << "still there while it is on its way";
  session.cancel_opening();
  const SessionChanges changes = settle(session);
  EXPECT_TRUE(changes.options);
  EXPECT_TRUE(session.open_options().assembly.empty());
  EXPECT_EQ(session.state().ours, ours);
  EXPECT_TRUE(session.state().last_error.empty());
}

TEST_F(SessionTest, AnotherFileForgetsWhatWasChosenForTheLast) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  OpenOptions options;
  options.balls.radii = RadiiSet::bondi;
  options.balls.selection = "resi 1";
  options.balls.without_chains = {"A"};
  options.balls.overrides = {{"", "C", 6, 1000000}};
  session->set_open_options(options);
  settle(*session);
  session->open(bad_);
  settle(*session);
  EXPECT_EQ(session->open_options(), options) << "the file could not be opened";
  session->open(other_);
  settle(*session);
  EXPECT_EQ(session->open_options(), for_another_file(options));
  EXPECT_TRUE(session->open_options().balls.selection.empty());
  EXPECT_TRUE(session->open_options().balls.without_chains.empty());
  EXPECT_TRUE(session->open_options().balls.overrides.empty());
  EXPECT_EQ(session->open_options().balls.radii, RadiiSet::bondi) << "a rule, not of one file";
  EXPECT_EQ(session->state().prepared->report.radii, RadiiSet::bondi);
}

TEST_F(SessionTest, OptionsSetWhileABadFileIsReadStillApply) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  session->open(bad_);
  OpenOptions options = session->open_options();
  options.balls.radii = RadiiSet::alvarez;
  session->set_open_options(options);
  settle(*session);
  EXPECT_EQ(session->open_options(), options);
  EXPECT_EQ(session->state().prepared->report.radii, RadiiSet::alvarez);
}

TEST_F(SessionTest, ATableOfRadiiIsReadInTheBackground) {
  const auto session = make();
  session->open(good_);
  settle(*session);
  OpenOptions options;
  options.balls.radii = RadiiSet::user;
  options.radii_table = write("radii.txt", "X 2.5\n");
  session->set_open_options(options);
  settle(*session);
  EXPECT_EQ(session->state().prepared->balls->radii, std::vector<std::int32_t>(4, 2500));
  options.radii_table = write("bad.txt", "C banana\n");
  session->set_open_options(options);
  settle(*session);
  EXPECT_NE(session->state().last_error.find("bad.txt, line 1"), std::string::npos)
      << session->state().last_error;
  EXPECT_EQ(session->open_options().radii_table.filename(), "radii.txt");
}

TEST_F(SessionTest, UnusedMemoryIsFreedByAnotherThread) {
  std::atomic<bool> unused{false};
  std::atomic<int> freed{0};
  std::thread::id thread;
  Session::Services services = Session::program_services();
  services.make_engine = fake_factory(log_);
  services.is_memory_unused = [&] { return unused.load(); };
  services.free_unused_memory = [&] {
    if (freed == 0) thread = std::this_thread::get_id();  // it may be called again meanwhile
    unused = false;
    ++freed;
  };
  Session session({}, services);
  session.open(good_);
  settle(session);
  EXPECT_EQ(freed, 0);
  unused = true;
  ASSERT_TRUE(poll_until(session, [&] { return freed > 0; }));
  EXPECT_NE(thread, std::this_thread::get_id());
  EXPECT_FALSE(session.activity().computing.busy);
}

TEST_F(SessionTest, DestructionDuringWorkJoins) {
  log_.hold = true;
  const auto session = make();
  session->open(good_);
  while (log_.started == 0) session->poll();
}

TEST_F(SessionTest, AnAnswerBringsWhatItsEngineMadeOfAllBalls) {
  Session::Services services = Session::program_services();
  Session session({}, services);
  Request request;
  request.engine = EngineChoice::cgal;
  session.set_request(request);
  session.open(good_);
  settle(session);
  const auto first = session.state().ours;
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kept_bytes, 0u);
  ASSERT_TRUE(first->made->filtration);
  EXPECT_EQ(&first->made->filtration->balls(), first->balls.get());
  const std::uint64_t with_made = session.held_bytes();
  const ResultsForAllAlphas of_first = std::exchange(*first->made, {});
  EXPECT_LT(session.held_bytes(), with_made) << "it has another owner";
  EXPECT_EQ(of_first.filtration.use_count(), 1);

  // The same balls need no other one.
  request.alpha_angstrom2 = 1;
  session.set_request(request, of_first);
  settle(session);
  EXPECT_EQ(session.state().ours->complex.engine.route, kThresholdRoute);
  EXPECT_FALSE(*session.state().ours->made);

  request.solvent_radius_angstrom = 1;
  session.set_request(request, of_first);
  settle(session);
  const auto second = session.state().ours;
  ASSERT_NE(second->balls, first->balls);
  EXPECT_TRUE(second->made->triangulation);
  session.open(other_);
  settle(session);
  EXPECT_NE(session.state().ours->made->filtration, second->made->filtration);
}

// If the picture of an answer never comes, the next answer's picture brings its result to the
// store.
TEST_F(SessionTest, WhatWasMadeOfAllBallsGoesOnToTheNextAnswer) {
  Session::Services services = Session::program_services();
  Session session({}, services);
  Request request;
  request.engine = EngineChoice::cgal;
  session.set_request(request);
  session.open(good_);
  settle(session);
  const auto first = session.state().ours;
  const auto filtration = first->made->filtration;
  ASSERT_TRUE(filtration);
  request.alpha_angstrom2 = 1;
  session.set_request(request);
  settle(session);
  const auto second = session.state().ours;
  EXPECT_EQ(second->complex.engine.route, kThresholdRoute);
  EXPECT_EQ(second->made->filtration, filtration);
  EXPECT_FALSE(*first->made);
  request.solvent_radius_angstrom = 1;
  session.set_request(request);
  settle(session);
  EXPECT_EQ(second->made->filtration, filtration) << "of other balls";
}

TEST_F(SessionTest, SmallerAlphasOnTheCpuAreThresholds) {
  Session::Services services = Session::program_services();
  Session session({}, services);
  Request request;
  request.engine = EngineChoice::cpu;
  request.alpha_angstrom2 = 2;
  session.set_request(request);
  session.open(good_);
  settle(session);
  ASSERT_EQ(session.state().ours->complex.engine.route, kClippingRoute);
  request.alpha_angstrom2 = 1;
  session.set_request(request);
  settle(session);
  EXPECT_EQ(session.state().ours->complex.engine.route,
            "filtration of cached complex, then threshold");
  EXPECT_GT(session.state().ours->kept_bytes, 0u);
}

}  // namespace
}  // namespace alphascope
