// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the contestants in turns, each with a time limit of its own, and takes medians.
#include "app/bench/rounds_suite.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iterator>
#include <new>
#include <utility>

#include "app/bench/deadline.hpp"
#include "app/bench/report_columns.hpp"
#include "app/bench/thesis_contest.hpp"
#include "app/bench/thesis_table.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/cgal_triangulation.hpp"
#include "core/triangulation/triangulation_maker.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

// One way to the whole triangulation, with its results and times.
struct Runner {
  std::string name;
  std::function<void(const RunContext& context)> run;  // sets `name` where only the run tells it
  std::vector<double> milliseconds = {};
  std::vector<std::vector<double>> of_steps = {};  // of the rounds and their completion, by run
  double seconds = 0;                              // spent
  bool live = true;
  std::string skipped = {};
};

// As the contest does, drops the first run if there are others.
std::vector<double> counted_runs(std::vector<double> all) {
  if (all.size() > 1) all.erase(all.begin());
  return all;
}

class OneMolecule {
 public:
  OneMolecule(const ThesisMolecule& molecule, std::size_t index, const ThesisOptions& options,
              const std::shared_ptr<TriangulationMaker>& usual, const RunContext& context)
      : molecule_(molecule),
        index_(index),
        options_(options),
        cancel_(context.cancel),
        threads_(std::make_shared<WorkThreads>(options.threads)) {
    const BallSet& balls = *molecule.balls;
    runners_ = {
        {kThesisRoundsName,
         [this](const RunContext& quiet) {
           rounds_ = make_thesis_rounds(molecule_.balls, threads_, quiet);
           note_steps();
         }},
        {"usual way",
         [this, usual, &balls](const RunContext& quiet) {
           threads_->run([&] { usual_ = make_triangulation_by(usual, balls, 0, quiet); });
           const TriangulationReport& by = *usual_.report;
           const bool inserted = by.by == TriangulationReport::By::insertion;
           runners_[1].name =
               std::string("usual way: ") + (inserted ? "insertion, " : "") + by.maker;
         }},
        {"CGAL", [this, &balls](const RunContext& quiet) {
           threads_->run([&] { cgal_ = make_cgal_triangulation(balls, threads_->used(), quiet); });
         }}};
  }

  std::vector<RoundsRow> rows() {
    for (int turn = 0; turn <= options_.repeats; ++turn) {
      for (Runner& runner : runners_) {
        cancel_.throw_if_cancelled();
        if (runner.live) take_turn(runner);
      }
    }
    std::vector<RoundsRow> rows;
    add_steps(rows);
    rows.push_back(whole(runners_[0], rounds_.tetrahedra));
    if (runners_[0].skipped.empty()) {
      const bool deep = rounds_.dimension == 3;
      rows.back().step.saturated = rounds_.completion.saturated;
      rows.back().step.hidden = rounds_.completion.hidden;
      rows.back().step.unsaturated =
          deep ? rounds_.completion.unsaturated : molecule_.balls->size();
    }
    rows.push_back(whole(runners_[1], usual_.tetrahedra));
    rows.push_back(whole(runners_[2], cgal_.tetrahedra));
    return rows;
  }

 private:
  void take_turn(Runner& runner) {
    const double left = options_.seconds_per_row - runner.seconds;
    const Clock::time_point start = Clock::now();
    const auto milliseconds = [&] {
      return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    };
    runner.live = false;
    try {
      if (left <= 0) return;
      const Deadline deadline(cancel_, left);
      RunContext quiet;  // no progress reports during timing
      quiet.cancel = deadline.token();
      runner.run(quiet);
      runner.milliseconds.push_back(milliseconds());
      runner.live = true;
    } catch (const Cancelled&) {
      cancel_.throw_if_cancelled();
      if (runner.milliseconds.empty()) runner.skipped = over_seconds(options_.seconds_per_row);
    } catch (const std::bad_alloc&) {
      runner.skipped = "not enough memory";
    } catch (const std::exception& e) {
      runner.skipped = e.what();
    }
    runner.seconds += milliseconds() / 1000;
  }

  void note_steps() {
    std::vector<double> times;
    for (const ThesisRound& round : rounds_.rounds) times.push_back(round.milliseconds);
    times.push_back(rounds_.completion.milliseconds);
    runners_[0].of_steps.push_back(std::move(times));
  }

  RoundsRow row(RoundsRow::Kind kind, const Runner& runner) const {
    RoundsRow row;
    row.kind = kind;
    row.molecule = molecule_.name;
    row.molecule_index = index_;
    row.balls = molecule_.balls->size();
    row.by_rounds = &runner == &runners_.front();
    row.maker = runner.name;
    row.skipped = runner.skipped;
    row.runs = static_cast<int>(counted_runs(runner.milliseconds).size());
    return row;
  }

  void add_steps(std::vector<RoundsRow>& rows) const {
    const Runner& runner = runners_[0];
    if (!runner.skipped.empty() || rounds_.rounds.empty()) return;
    for (std::size_t n = 0; n <= rounds_.rounds.size(); ++n) {
      const bool last = n == rounds_.rounds.size();
      RoundsRow step = row(last ? RoundsRow::Kind::completion : RoundsRow::Kind::round, runner);
      step.number = last ? 0 : n + 1;
      step.step = last ? rounds_.completion : rounds_.rounds[n];
      std::vector<double> times;
      for (const std::vector<double>& run : runner.of_steps) times.push_back(run[n]);
      step.milliseconds = median(counted_runs(times));
      rows.push_back(std::move(step));
    }
  }

  RoundsRow whole(const Runner& runner, const Simplices<4>& tetrahedra) const {
    RoundsRow made = row(RoundsRow::Kind::whole, runner);
    if (!made.measured()) return made;
    made.milliseconds = median(counted_runs(runner.milliseconds));
    made.step.tetrahedra = tetrahedra.size();
    if (runners_[2].skipped.empty()) made.same_as_cgal = tetrahedra == cgal_.tetrahedra;
    return made;
  }

  const ThesisMolecule& molecule_;
  std::size_t index_;
  const ThesisOptions& options_;
  const CancelToken& cancel_;
  std::shared_ptr<WorkThreads> threads_;
  std::vector<Runner> runners_;
  ThesisRounds rounds_;
  Triangulation usual_, cgal_;
};

using Row = RoundsTableRow;
using Kind = RoundsRow::Kind;

const char* kind_id(Kind kind) {
  return kind == Kind::round ? "round" : kind == Kind::completion ? "completion" : "whole";
}

CellValue count(std::uint64_t number) {
  return number;
}

// The value if it was measured and applies, else none.
CellValue when(bool applies, const CellValue& value) {
  return applies ? value : CellValue();
}
bool is_step(const Row& r) {
  return r.row.measured() && r.row.kind != Kind::whole;
}
bool has_balls(const Row& r) {
  return r.row.measured() && r.row.by_rounds;
}

const ThesisReport& suite_of(const Row& r) {
  return r.report.suite;
}

const Column<Row> kColumns[] = {
    kMoleculeColumn<Row>,
    kBallsColumn<Row>,
    kSolventColumn<Row, suite_of>,
    {.id = "maker",
     .title = "by",
     .help = "“the thesis' rounds”, or what made the whole triangulation in another way.",
     .value = [](const Row& r) -> CellValue { return r.row.maker; }},
    {.id = "kind",
     .title = "kind",
     .help = "“round”; “completion”: the star completion after the rounds; or “whole”: the way to "
             "the whole triangulation.",
     .value = [](const Row& r) -> CellValue { return std::string(kind_id(r.row.kind)); }},
    {.id = "round",
     .title = "round",
     .help = "The number of the round, from 1.",
     .value = [](const Row& r) { return when(r.row.number > 0, count(r.row.number)); }},
    {.id = "alpha_angstrom2",
     .title = "alpha",
     .unit = "Å²",
     .help = "The alpha of the round.",
     .value =
         [](const Row& r) {
           return when(r.row.kind == Kind::round, r.row.step.alpha_angstrom2.nearest());
         }},
    {.id = "computed_balls",
     .title = "computed",
     .help = "The balls that the round computes: the unsaturated ones and those that share a known "
             "tetrahedron with one of them.",
     .value = [](const Row& r) { return when(is_step(r), count(r.row.step.balls)); }},
    {.id = "saturated",
     .title = "saturated",
     .help = "The saturated balls after it. Their tetrahedra are final.",
     .value = [](const Row& r) { return when(has_balls(r), count(r.row.step.saturated)); }},
    {.id = "saturated_share",
     .title = "saturated",
     .help = "Their share of all balls, 0 to 1.",
     .value =
         [](const Row& r) {
           const auto share = r.row.saturated_share();
           return share ? CellValue(*share) : CellValue();
         }},
    {.id = "hidden",
     .title = "hidden",
     .help = "The balls that are known to be hidden after it. They leave as well.",
     .value = [](const Row& r) { return when(has_balls(r), count(r.row.step.hidden)); }},
    {.id = "unsaturated",
     .title = "|U|",
     .help = "All other balls after it, those of the hull included.",
     .value = [](const Row& r) { return when(has_balls(r), count(r.row.step.unsaturated)); }},
    {.id = "tetrahedra",
     .title = "tetrahedra",
     .help = "The tetrahedra that are known after it.",
     .value = [](const Row& r) { return when(r.row.measured(), count(r.row.step.tetrahedra)); }},
    {.id = "new_tetrahedra",
     .title = "new",
     .help = "Those of them that were not known before it.",
     .value = [](const Row& r) { return when(is_step(r), count(r.row.step.new_tetrahedra)); }},
    {.id = "median_ms",
     .title = "time",
     .unit = "ms",
     .help = "The wall time, to a tenth of a microsecond; the median of the counted runs.",
     .value =
         [](const Row& r) {
           return when(r.row.measured(), std::round(r.row.milliseconds * 1e4) / 1e4);
         }},
    {.id = "runs",
     .title = "runs",
     .help = "The number of counted runs.",
     .value =
         [](const Row& r) {
           return when(r.row.measured(), count(static_cast<std::uint64_t>(r.row.runs)));
         }},
    {.id = "route",
     .title = "route",
     .help = "The way in which the round computed its balls.",
     .value = [](const Row& r) -> CellValue { return r.row.step.route; }},
    {.id = "same_as_cgal",
     .title = "same",
     .help = "The whole triangulation has the tetrahedra of CGAL's; empty if CGAL was left out.",
     .value =
         [](const Row& r) {
           return r.row.same_as_cgal ? CellValue(*r.row.same_as_cgal) : CellValue();
         }},
    {.id = "skipped",
     .title = "skipped",
     .help = "The reason why nothing was measured; else empty.",
     .value = [](const Row& r) -> CellValue { return r.row.skipped; }},
    kProgramColumn<Row, suite_of>,
    kCpuColumn<Row, suite_of>,
    {.id = "threads",
     .title = "threads",
     .help = "The number of CPU threads.",
     .value = [](const Row& r) -> CellValue {
       const int asked = r.report.suite.options.threads;
       return count(static_cast<std::uint64_t>(asked > 0 ? asked : r.report.suite.machine.threads));
     }}};

}  // namespace

std::optional<double> RoundsRow::saturated_share() const {
  if (!measured() || !by_rounds || balls == 0) return std::nullopt;
  return static_cast<double>(step.saturated) / static_cast<double>(balls);
}

std::string rounds_step_text(const RoundsRow& row) {
  if (row.kind == Kind::round) return "round " + std::to_string(row.number);
  return row.kind == Kind::completion ? "star completion" : "whole";
}

bool RoundsReport::all_same() const {
  return std::none_of(rows.begin(), rows.end(),
                      [](const RoundsRow& row) { return row.same_as_cgal == false; });
}

RoundsReport run_rounds_suite(const std::vector<ThesisMolecule>& molecules,
                              const ThesisOptions& options,
                              const std::shared_ptr<TriangulationMaker>& usual,
                              const RunContext& context, const RoundsListener& listener) {
  RoundsReport report{thesis_report(molecules, options), {}};
  for (std::size_t m = 0; m < molecules.size(); ++m) {
    context.report(molecules[m].name + ", " + kThesisRoundsName,
                   static_cast<double>(m) / static_cast<double>(molecules.size()));
    std::vector<RoundsRow> rows =
        OneMolecule(molecules[m], m, report.suite.options, usual, context).rows();
    if (listener) listener(rows);
    std::move(rows.begin(), rows.end(), std::back_inserter(report.rows));
  }
  return report;
}

std::span<const Column<RoundsTableRow>> rounds_columns() {
  return kColumns;
}

std::vector<CsvRow> rounds_csv(const RoundsReport& report) {
  std::vector<CsvRow> rows;
  for (const RoundsRow& row : report.rows) {
    CsvRow& cells = rows.emplace_back();
    for (const Column<RoundsTableRow>& column : kColumns) {
      cells.emplace_back(column.id, shortest_cell(column.value({report, row})));
    }
    const auto& provenance = report.suite.molecules[row.molecule_index].provenance;
    cells.insert(cells.end(), provenance.begin(), provenance.end());
  }
  return rows;
}

}  // namespace alphascope
