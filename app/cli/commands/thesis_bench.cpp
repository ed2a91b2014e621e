// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli bench --suite thesis for the named molecules on this machine. Writes the
// thesis' rounds (Part I), its Table 4.1 and the data of its figures. The suites,
// app/bench/rounds_suite.hpp and app/bench/thesis_suite.hpp, describe the measurements.
#include <cstdio>
#include <iostream>

#include "app/bench/rounds_suite.hpp"
#include "app/bench/thesis_charts.hpp"
#include "app/bench/thesis_table.hpp"
#include "app/cli/commands/bench.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/session/gpu_engines.hpp"
#include "core/chart/layout.hpp"
#include "core/chart/readable_number.hpp"
#include "core/chart/svg.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

constexpr double kThesisAlphas[] = {0, 1.4, 3};  // Å²
constexpr const char* kRoundsLine = "%-14s %-16s %9s %9s %9s %9s %10s %10s %10s  %s\n";

ThesisOptions to_suite(const BenchOptions& options) {
  if (options.request.engine != EngineChoice::automatic) {
    throw UsageError("--suite thesis takes --engines, such as --engines cpu,tuples-cpu");
  }
  if (options.threads.size() != 1) {
    throw UsageError("--suite thesis takes one number of --threads");
  }
  ThesisOptions suite;
  suite.alphas.assign(options.alphas.begin(), options.alphas.end());
  if (suite.alphas.empty()) suite.alphas.assign(std::begin(kThesisAlphas), std::end(kThesisAlphas));
  for (const std::string& id : options.engines) suite.engines.push_back(*engine_from_id(id));
  if (suite.engines.empty()) suite.engines = thesis_engines(machine_info());
  suite.solvent_radius_angstrom = options.request.solvent_radius_angstrom;
  suite.threads = options.threads.front();
  suite.repeats = options.runs;
  suite.seconds_per_row = options.seconds_per_row;
  suite.ablation = options.ablation;
  return suite;
}

std::vector<ThesisMolecule> read_all(const BenchOptions& options, const RunContext& context) {
  std::vector<ThesisMolecule> molecules;
  for (const std::string& file : options.files) {
    InputOptions one = options.input;
    one.file = file;
    for_each_model(one, context, [&](const Input& input) {
      std::shared_ptr<const BallSet> balls = input.prepared().balls;
      if (options.request.solvent_radius_angstrom != 0) {
        balls = std::make_shared<const BallSet>(
            with_solvent(*balls, options.request.solvent_radius_angstrom));
      }
      std::string name = printable(input.molecule().source.filename().string());
      name.erase(std::min(name.find('.'), name.size()));
      if (each_model(options.input)) name += ", model " + model_text(input.balls.model);
      molecules.push_back({name, balls, input.provenance()});
    });
  }
  return molecules;
}

std::string column(const std::optional<double>& milliseconds) {
  char text[32];
  if (!milliseconds) return "-";
  std::snprintf(text, sizeof text, *milliseconds < 100 ? "%.3f" : "%.1f", *milliseconds);
  return text;
}

void print_header() {
  std::cout << format_text(
                   "\n%-14s %8s %7s  %-18s %9s %9s %9s %9s %9s %9s %10s %10s %8s %10s %7s  %s\n",
                   "molecule", "balls", "alpha", "engine", "memcpy", "kernel1", "prefixsum",
                   "kernel2", "kernel3", "other", "cold ms", "warm ms", "speed-up", "tetrahedra",
                   "of full", "note")
            << std::flush;
}

std::string note_of(const ThesisRow& row) {
  std::string note;
  const auto add = [&note](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (row.same_as_cgal == false) add("DIFFERS FROM CGAL");
  if (row.kind == ThesisRow::Kind::ablation) add(row.variant);
  if (!row.skipped.empty()) add("left out: " + row.skipped);
  if (row.measured() && !row.same_as_cgal) add("not compared");
  if (row.stages.kernel1_has_kernel2)
    add("kernel1 contains kernels I and II, which one launch runs");
  return note;
}

std::string engine_text(const ThesisRow& row) {
  if (row.kind == ThesisRow::Kind::cgal) return contestant_text(row);
  return std::string(engine_id(row.choice)) + (row.kind == ThesisRow::Kind::ablation ? " *" : "");
}

void print_row(const ThesisRow& row) {
  clear_progress();
  const bool ok = row.measured();
  const auto ms = [ok](double milliseconds) {
    return column(ok ? std::optional(milliseconds) : std::nullopt);
  };
  const auto ratio = row.speed_up();
  const auto share = row.share_of_full();
  std::cout << format_text(
                   "%-14s %8s %7s  %-18s %9s %9s %9s %9s %9s %9s %10s %10s %8s %10s %7s  %s\n",
                   row.molecule.c_str(), grouped(row.balls).c_str(),
                   shortest_number(row.alpha_angstrom2).c_str(), engine_text(row).c_str(),
                   column(row.stages.memcpy).c_str(), column(row.stages.kernel1).c_str(),
                   column(row.stages.prefix_sum).c_str(), column(row.stages.kernel2).c_str(),
                   column(row.stages.kernel3).c_str(), column(row.stages.other).c_str(),
                   ms(row.cold_milliseconds).c_str(), ms(row.warm_milliseconds).c_str(),
                   ratio ? (chart_number(*ratio) + "x").c_str() : "-",
                   ok ? grouped(row.tetrahedra).c_str() : "-",
                   share ? (chart_number(100 * *share) + "%").c_str() : "-", note_of(row).c_str())
            << std::flush;
}

void print_break_even(const ThesisReport& report) {
  std::cout << "\nLargest alpha at which the engine is faster than CGAL with one thread, both cold"
            << " (bisected between the alphas measured, " << report.options.bisections
            << " times):\n";
  for (const BreakEven& found : report.break_even) {
    std::cout << "  " << report.molecules[found.molecule_index].name << ", "
              << engine_id(found.choice) << ": " << break_even_text(found) << "\n";
  }
  std::cout << std::flush;
}

void print_rounds_header() {
  std::cout << "\nPart I: the thesis' rounds. α grows, saturated balls leave, and the star "
               "completion finds the rest.\nOnly this benchmark makes triangulations so; \"whole\" "
               "compares with the program's usual way and with CGAL.\n"
            << format_text(kRoundsLine, "molecule", "step", "alpha", "computed", "saturated", "|U|",
                           "tetrahedra", "new", "ms", "how");
}

void print_rounds(std::span<const RoundsRow> rows) {
  clear_progress();
  for (const RoundsRow& row : rows) {
    const ThesisRound& step = row.step;
    const bool ok = row.measured(), is_step = ok && row.kind != RoundsRow::Kind::whole;
    const auto number = [](bool known, std::size_t n) { return known ? grouped(n) : "-"; };
    const auto share = row.saturated_share();
    std::string how = is_step ? step.route : row.maker;
    if (!ok) how += ": left out: " + row.skipped;
    if (row.same_as_cgal == false) how += ": DIFFERS FROM CGAL";
    std::cout << format_text(
        kRoundsLine, row.molecule.c_str(), rounds_step_text(row).c_str(),
        row.kind == RoundsRow::Kind::round ? shortest_number(step.alpha_angstrom2).c_str() : "-",
        number(is_step, step.balls).c_str(),
        share ? format_text("%.2f%%", 100 * *share).c_str() : "-",
        number(ok && row.by_rounds, step.unsaturated).c_str(), number(ok, step.tetrahedra).c_str(),
        number(is_step, step.new_tetrahedra).c_str(),
        column(ok ? std::optional(row.milliseconds) : std::nullopt).c_str(), how.c_str());
  }
  std::cout << std::flush;
}

Json rounds_json(const RoundsReport& report) {
  Json rows = Json::array();
  for (const RoundsRow& row : report.rows) {
    Json& json = rows.emplace_back(Json::object());
    add_keys_up_to(json, rounds_columns(), {report, row});
    for (const auto& [key, value] : report.suite.molecules[row.molecule_index].provenance) {
      json[key] = value;
    }
  }
  return rows;
}

Json to_json(const ThesisReport& report, const RoundsReport& rounds) {
  Json rows = Json::array();
  for (const ThesisRow& row : report.rows) {
    Json& json = rows.emplace_back(Json::object());
    add_keys_up_to(json, thesis_columns(), {report, row});
    for (const auto& [key, value] : report.molecules[row.molecule_index].provenance) {
      json[key] = value;
    }
  }
  return {{"program", program_json()},
          {"machine", machine_text(report.machine)},
          {"suite", "thesis"},
          {"repeats", report.options.repeats},
          {"seconds_per_row", report.options.seconds_per_row},
          {"bisections", report.options.bisections},
          {"rounds", rounds_json(rounds)},
          {"rows", rows}};
}

void write_charts_of(const ThesisReport& report, const std::string& folder) {
  if (folder.empty()) return;
  for (const auto& path : write_charts(thesis_charts(report), folder)) {
    std::cout << "wrote " << printable(path.string()) << "\n";
  }
}

}  // namespace

ExitCode run_thesis_bench(const BenchOptions& options) {
  const RunContext& context = run_context();
  const ThesisOptions suite = to_suite(options);
  require_readable({options.files.begin(), options.files.end()});
  Outputs outputs(files_read(options.files, {}, options.input));
  AtomicFile* const csv = outputs.add("--csv", options.csv, Outputs::kCsv);
  AtomicFile* const rounds_csv_file = outputs.add("--rounds", options.rounds, Outputs::kCsv);
  AtomicFile* const json = outputs.add("--json", options.json, Outputs::kJson);
  if (!options.charts.empty()) make_output_folder(options.charts);
  const std::vector<ThesisMolecule> molecules = read_all(options, context);
  clear_progress();
  const MachineInfo& machine = machine_info();
  std::cout << machine_text(machine) << "\n"
            << (machine.gpu.usable ? "" : machine.gpu.why_not + "\n") << "medians of up to "
            << suite.repeats << " runs after one that is not counted; times in ms, alpha in Å²; "
            << "tetrahedra only; speed-up = CGAL's cold time with one thread / cold time; "
            << "* = an optimisation switched off\n";
  print_rounds_header();
  const RoundsReport rounds =
      run_rounds_suite(molecules, suite, GpuEngines::of_program().triangulations(), context,
                       RoundsListener(print_rounds));
  clear_progress();
  std::cout << "\nPart II: the thesis' Table 4.1";
  print_header();
  const ThesisReport report =
      run_thesis_suite(molecules, suite, make_engine, context, RowListener(print_row));
  clear_progress();
  print_break_even(report);
  if (csv) csv->write(csv_text(thesis_csv(report)));
  if (rounds_csv_file) rounds_csv_file->write(csv_text(rounds_csv(rounds)));
  if (json) json->write(json_text(to_json(report, rounds)));
  outputs.commit();
  write_charts_of(report, options.charts);
  return report.all_same() && rounds.all_same() ? ExitCode::ok : ExitCode::differs;
}

}  // namespace alphascope::cli
