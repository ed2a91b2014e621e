// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the engines in turns, each with a deadline of its own.
#include "app/bench/thesis_contest.hpp"

#include <algorithm>
#include <new>

#include "app/bench/deadline.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

// The warm run's alpha is smaller by this. It is the smallest step of a slider that a user can
// notice.
constexpr double kSliderStep = 0.001;  // Å²

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class Contest {
 public:
  Contest(const ContestRules& rules, const EngineFactory& factory, const CancelToken& cancel)
      : rules_(rules), factory_(factory), cancel_(cancel) {}

  // Runs the contestant once. Returns false if it takes no further turn, because its time is over
  // or it has failed.
  bool turn(Contestant& c, double& seconds_spent) {
    const double left = rules_.seconds - seconds_spent;
    if (left <= 0) return false;
    const Clock::time_point start = Clock::now();
    bool go_on = false;
    try {
      const Deadline deadline(cancel_, left);
      run(c, deadline.token());
      go_on = true;
    } catch (const Cancelled&) {
      cancel_.throw_if_cancelled();
      c.too_slow = !c.measured();
      if (c.too_slow) c.skipped = over_seconds(rules_.seconds);
    } catch (const std::bad_alloc&) {
      fail(c, "not enough memory");
    } catch (const std::exception& e) {
      fail(c, e.what());
    }
    seconds_spent += milliseconds_since(start) / 1000;
    return go_on;
  }

 private:
  void run(Contestant& c, const CancelToken& token) {
    RunContext quiet;  // no progress reports during timing
    quiet.cancel = token;
    AlphaRequest at = rules_.request;
    Clock::time_point start = Clock::now();
    const MadeEngine made = factory_(c.choice, rules_.balls, c.settings);
    KnownResults known;
    const auto complex = std::make_shared<AlphaComplex>(made.engine->compute(at, known, quiet));
    const double cold = milliseconds_since(start);
    const std::size_t tetrahedra = complex->tetrahedra.size();
    known.share(complex);
    if (!known.complex) let_go(*complex);
    at.alpha_angstrom2 = at.alpha_angstrom2 - kSliderStep;
    start = Clock::now();
    made.engine->compute(at, known, quiet);
    const double warm = milliseconds_since(start);
    c.hashes_agree &= !c.measured() || c.hash == complex->hash;
    c.cold.push_back(cold);
    c.warm.push_back(warm);
    c.cold_stages.push_back(complex->timings.stages);
    c.engine = complex->engine;
    c.tetrahedra = tetrahedra;
    c.hash = complex->hash;
  }

  // Frees the simplices, so the engine can use their memory for the next result, as while a slider
  // moves.
  static void let_go(AlphaComplex& complex) {
    complex.vertices = {};
    complex.edges = {};
    complex.triangles = {};
    complex.tetrahedra = {};
  }

  static void fail(Contestant& c, const std::string& why) {
    c.skipped = why;
    c.cold.clear();
    c.warm.clear();
    c.cold_stages.clear();
  }

  const ContestRules& rules_;
  const EngineFactory& factory_;
  const CancelToken& cancel_;
};

// Drops the first run if there are others. It alone pays for page faults, cold caches and the
// device's start.
void drop_first_run(Contestant& c) {
  if (c.cold.size() < 2) return;
  c.cold.erase(c.cold.begin());
  c.warm.erase(c.warm.begin());
  c.cold_stages.erase(c.cold_stages.begin());
}

double milliseconds_of(const std::vector<StageTime>& stages, const std::string& label) {
  double sum = 0;
  for (const StageTime& s : stages) sum += s.label == label ? s.milliseconds : 0;
  return sum;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<StageTime> Contestant::stage_medians() const {
  std::vector<StageTime> medians;
  if (cold_stages.empty()) return medians;
  for (const StageTime& stage : cold_stages.front()) {
    const bool seen = std::any_of(medians.begin(), medians.end(),
                                  [&](const StageTime& m) { return m.label == stage.label; });
    if (seen) continue;
    std::vector<double> all;
    all.reserve(cold_stages.size());
    for (const auto& run : cold_stages) all.push_back(milliseconds_of(run, stage.label));
    medians.push_back({stage.label, median(std::move(all)), stage.setup});
  }
  return medians;
}

void run_contest(std::vector<Contestant>& contestants, const ContestRules& rules,
                 const EngineFactory& factory, const CancelToken& cancel) {
  Contest contest(rules, factory, cancel);
  std::vector<double> spent(contestants.size(), 0);
  std::vector<char> live;
  live.reserve(contestants.size());
  for (const Contestant& c : contestants) live.push_back(c.skipped.empty());
  // Contestants take turns, so a slowdown of the machine affects all of them.
  for (int round = 0; round <= rules.repeats; ++round) {
    for (std::size_t n = 0; n < contestants.size(); ++n) {
      cancel.throw_if_cancelled();
      if (live[n]) live[n] = contest.turn(contestants[n], spent[n]);
    }
  }
  for (Contestant& c : contestants) drop_first_run(c);
}

}  // namespace alphascope
