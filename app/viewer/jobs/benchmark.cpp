// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the controls of the benchmark, runs the suite, passes its rows to the main thread, and
// writes its files.
#include "app/viewer/jobs/benchmark.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/bench/thesis_charts.hpp"
#include "app/bench/thesis_table.hpp"
#include "core/chart/layout.hpp"
#include "core/chart/readable_number.hpp"
#include "core/chart/svg.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/export/program_name.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/provenance.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/printable.hpp"
#include "core/write/csv.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

std::vector<std::string> columns() {
  return {"alpha (Å²)",     "engine",          "memcpy (ms)", "kernel I (ms)", "prefix sum (ms)",
          "kernel II (ms)", "kernel III (ms)", "other (ms)",  "cold (ms)",     "warm (ms)",
          "speed-up",       "tetrahedra",      "of full (%)", "same as CGAL",  "note"};
}

std::string ms(const std::optional<double>& milliseconds) {
  return milliseconds ? chart_number(*milliseconds) : "–";
}

std::vector<std::string> cells(const ThesisRow& row) {
  const bool ok = row.measured();
  const auto when = [ok](const std::string& text) { return ok ? text : std::string("–"); };
  const ThesisStages& s = row.stages;
  const auto ratio = row.speed_up();
  const auto share = row.share_of_full();
  std::string note = ok ? row.engine.device : "left out: " + row.skipped;
  if (s.kernel1_has_kernel2) note += "; kernel I is I + II in one launch";
  return {chart_number(row.alpha_angstrom2),
          contestant_text(row),
          ms(s.memcpy),
          ms(s.kernel1),
          ms(s.prefix_sum),
          ms(s.kernel2),
          ms(s.kernel3),
          ms(s.other),
          when(chart_number(row.cold_milliseconds)),
          when(chart_number(row.warm_milliseconds)),
          ratio ? ratio_text(*ratio) : "–",
          when(with_separators(static_cast<long long>(row.tetrahedra))),
          share ? chart_number(100 * *share) : "–",
          !row.same_as_cgal   ? "not compared"
          : *row.same_as_cgal ? "yes"
                              : "NO",
          note};
}

void show(const ThesisRow& row, BenchmarkInfo& info) {
  info.rows.push_back(cells(row));
  info.differs.push_back(row.same_as_cgal == false);
}

std::vector<std::string> lines(const ThesisReport& report) {
  std::vector<std::string> text{machine_text(report.machine) + "; " + report.program};
  for (const BreakEven& found : report.break_even) {
    text.push_back(std::string(engine_id(found.choice)) +
                   " is faster than CGAL with one thread up to: " + break_even_text(found));
  }
  return text;
}

ThesisOptions to_options(const BenchmarkSettings& c, double solvent) {
  ThesisOptions options;
  options.alphas = parse_alphas(c.alphas);
  for (const EngineChoice choice : thesis_engines(machine_info())) {
    if (c.engines.contains(choice)) options.engines.push_back(choice);
  }
  options.solvent_radius_angstrom = solvent;
  options.repeats = c.runs;
  options.seconds_per_row = c.seconds_per_row;
  options.ablation = c.ablation;
  return options;
}

ThesisMolecule to_molecule(const SessionState& session) {
  const OpenedMolecule& opened = *session.opened;
  const double solvent = session.request.solvent_radius_angstrom;
  std::shared_ptr<const BallSet> balls = session.prepared->balls;
  if (solvent != 0) balls = std::make_shared<const BallSet>(with_solvent(*balls, solvent));
  std::string name = printable(opened.molecule->source.filename().string());
  name.erase(std::min(name.find('.'), name.size()));
  return {name, balls,
          provenance(*opened.molecule, opened.options.balls, session.prepared->report)};
}

void write_files(const ThesisReport& report, const std::vector<Chart>& charts,
                 const std::filesystem::path& folder, const RunContext& context) {
  make_output_folder(folder);
  std::vector<std::filesystem::path> names{folder / "thesis.csv"};
  for (const Chart& chart : charts) names.push_back(folder / (chart.id + ".svg"));
  write_together(
      names,
      [&](const std::vector<AtomicFile*>& files) {
        files[0]->write(csv_text(thesis_csv(report)));
        for (std::size_t k = 0; k < charts.size(); ++k) {
          context.cancel.throw_if_cancelled();
          files[k + 1]->write(chart_svg(charts[k]));
        }
      },
      context.cancel);
}

}  // namespace

std::vector<Alpha> parse_alphas(const std::string& text) {
  std::vector<Alpha> alphas;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t start = text.find_first_not_of(" ,;", k);
    if (start == std::string::npos) break;
    k = std::min(text.find_first_of(" ;", start), text.size());
    std::string word = text.substr(start, k - start);
    while (word.ends_with(',')) word.pop_back();  // other commas are decimal commas
    const AlphaInput input = read_alpha(word);
    if (!input.value) {
      throw std::invalid_argument(input.error +
                                  " Separate the numbers with blanks, as in 0, 1.4, 3");
    }
    alphas.push_back(*input.value);
  }
  if (alphas.empty()) throw std::invalid_argument("Write at least one alpha, such as 0, 1.4, 3");
  return alphas;
}

void Benchmark::start(const SessionState& session, const BenchmarkSettings& controls) {
  // An export would take time from the run.
  if (running_ || exports() || !session.opened || !session.prepared) return;
  info_ = {};
  info_.columns = columns();
  since_ = std::chrono::steady_clock::now();
  try {
    const ThesisOptions options = to_options(controls, session.request.solvent_radius_angstrom);
    const ThesisMolecule molecule = to_molecule(session);
    report_ = nullptr;
    partial_ = std::make_shared<ThesisReport>(thesis_report({molecule}, options));
    partial_->complete = false;
    failure_.clear();
    finished_ = cancelled_ = false;
    arrived_ = std::make_shared<Arrived>();
    worker_.submit(
        [this, options, molecule, arrived = arrived_](const RunContext& context) {
          const auto listener = [&](const ThesisRow& row) {
            const std::lock_guard lock(arrived->mutex);
            arrived->rows.push_back(row);
          };
          auto report = std::make_shared<const ThesisReport>(
              run_thesis_suite({molecule}, options, factory_, context, listener));
          return [this, report] {
            report_ = report;
            finished_ = true;
          };
        },
        [this](const Worker::Failure& failure) {
          cancelled_ = failure.cancelled;
          if (!cancelled_) failure_ = failure.message;
          finished_ = true;
        });
    running_ = info_.running = true;
  } catch (const std::exception& e) {
    info_.error = e.what();
  }
}

JobNews Benchmark::poll() {
  worker_.poll();
  if (!running_) return poll_files();
  JobNews news;
  news.changed = news.frees_memory = finished_;
  {
    const std::lock_guard lock(arrived_->mutex);
    news.changed |= !arrived_->rows.empty();
    for (const ThesisRow& row : arrived_->rows) {
      show(row, info_);
      partial_->rows.push_back(row);
    }
    arrived_->rows.clear();
  }
  const Worker::Activity activity = worker_.activity();
  news.changed |= info_.progress != activity.stage;
  info_.running = !finished_;
  info_.progress = activity.stage;
  info_.share = activity.share;
  if (finished_) finish();
  return news;
}

// The dialog shows a failure itself, so it has no window of its own.
JobNews Benchmark::poll_files() {
  JobNews news = files_.poll();
  info_.exporting = exports();
  if (!news.error.empty()) info_.error = std::exchange(news.error, {});
  if (info_.exported.empty() && !news.notice.empty()) info_.cancelled = news.notice;
  return news;
}

void Benchmark::cancel() {
  worker_.cancel();
  files_.cancel();
}

std::optional<RunningJob> Benchmark::running() const {
  if (!running_) return files_.running();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - since_;
  return RunningJob{JobId::benchmark, "Benchmark", info_.progress, info_.share, seconds.count()};
}

// Takes the end of a run. Rows of a cancelled or failed run stay, because they are valid and can be
// exported.
void Benchmark::finish() {
  running_ = false;
  info_.error = failure_;
  info_.complete = report_ != nullptr;
  if (!report_ && !partial_->rows.empty()) report_ = partial_;
  partial_ = nullptr;
  if (cancelled_) {
    info_.cancelled = report_ ? "Cancelled. These rows were measured before; they can be exported."
                              : "Cancelled before the first row was measured.";
  }
  info_.can_export = report_ != nullptr;
  if (!report_) return;
  info_.charts = thesis_charts(*report_);
  info_.lines = lines(*report_);
}

void Benchmark::save(const BenchmarkSettings& controls) {
  if (!report_ || exports()) return;
  info_.error.clear();
  info_.exported.clear();
  info_.cancelled.clear();
  const std::filesystem::path folder = std::filesystem::absolute(controls.folder);
  const std::string figures = counted(info_.charts.size(), "figure", "figures");
  const std::string text =
      "Wrote thesis.csv and " + figures + " to " + printable(folder.string()) +
      (report_->complete ? "" : ". The files state that the run is incomplete.");
  files_.start(
      {folder / "thesis.csv", "Exporting the benchmark", "The benchmark cannot be exported",
       [report = report_, charts = info_.charts, folder, figures](const RunContext& context) {
         write_files(*report, charts, folder, context);
         return " and " + figures;
       },
       [this, text] { info_.exported = text; }});
  info_.exporting = true;
}

}  // namespace alphascope
