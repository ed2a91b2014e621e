// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli bench, which prints median times of our engine and of CGAL in one process,
// cold and warm. Cold: a new engine is made and asked once, as after opening a molecule. CGAL's
// cold time covers triangulation and filter. Warm: the same engine is asked again at a slightly
// different alpha, as with a slider.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <span>

#include "app/cli/command.hpp"
#include "app/cli/commands/bench.hpp"
#include "app/cli/commands/columns.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/engine_cache.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/settings/request_columns.hpp"
#include "core/document/tables/column.hpp"
#include "core/engine/engine_choice.hpp"
#include "core/molecule/molecule.hpp"
#include "core/text/printable.hpp"
#include "core/write/csv.hpp"

namespace alphascope::cli {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

struct Series {
  std::vector<double> cold, warm;  // ms
  AlphaComplex complex;            // of the last cold run, with empty lists
  std::size_t tetrahedra = 0;
};

// The warm run's alpha differs by this. It is the smallest step of a slider that a user can notice.
constexpr double kSliderStep = 0.001;  // Å²

void run_once(const std::shared_ptr<const BallSet>& balls, const Request& request,
              const RunContext& context, Series& series) {
  MadeEngine made;
  KnownResults known;
  const auto complex = std::make_shared<AlphaComplex>();
  const AlphaRequest at{request.alpha_angstrom2, request.tetrahedra_only};
  series.cold.push_back(timed([&] {
    made = make_engine(request.engine, balls, {request.threads, request.tuples});
    *complex = made.engine->compute(at, known, context);
  }));
  known.share(complex);
  const AlphaRequest beside{request.alpha_angstrom2 - kSliderStep, request.tetrahedra_only};
  AlphaComplex moved;
  series.warm.push_back(timed([&] { moved = made.engine->compute(beside, known, context); }));
  series.tetrahedra = complex->tetrahedra.size();
  series.complex = {};
  series.complex.hash = complex->hash;
  series.complex.engine = complex->engine;
}

struct Row {
  std::string file;
  std::size_t balls = 0;
  Request request;
  Series ours, cgal;
  Provenance provenance;
  bool same() const { return ours.complex.hash == cgal.complex.hash; }
};

Row measure(const Input& input, const std::shared_ptr<const BallSet>& balls, const Request& request,
            int runs, const RunContext& context) {
  Row row{printable(input.molecule().source.filename().string()),
          balls->size(),
          request,
          {},
          {},
          input.provenance()};
  Request cgal = request;
  cgal.engine = EngineChoice::cgal;
  for (int run = 0; run < runs; ++run) {
    // The engines take turns, so a slowdown of the machine affects both.
    run_once(balls, request, context, row.ours);
    run_once(balls, cgal, context, row.cgal);
  }
  return row;
}

void print_header(const BenchOptions& options) {
  std::cout << "medians of " << options.runs << " runs, cold = new engine, warm = alpha moved by "
            << shortest_number(kSliderStep) << " Å²; ratio = CGAL cold / ours cold"
            << (options.request.tetrahedra_only ? "; tetrahedra only" : "") << "\n";
  std::cout << format_text("%-18s %9s %7s %7s %3s %10s %11s %11s %7s %11s %11s  %s\n", "file",
                           "balls", "alpha", "solvent", "thr", "tetrahedra", "cold ms", "CGAL cold",
                           "ratio", "warm ms", "CGAL warm", "engine")
            << std::flush;
}

void print_row(const Row& row) {
  const double cold = median(row.ours.cold), cgal = median(row.cgal.cold);
  std::cout << format_text(
                   "%-18s %9s %7s %7s %3d %10s %11.2f %11.2f %7.2f %11.2f %11.2f  %s, %s%s\n",
                   row.file.c_str(), grouped(row.balls).c_str(),
                   shortest_number(row.request.alpha_angstrom2).c_str(),
                   shortest_number(row.request.solvent_radius_angstrom).c_str(),
                   row.request.threads, grouped(row.ours.tetrahedra).c_str(), cold, cgal,
                   cgal / cold, median(row.ours.warm), median(row.cgal.warm),
                   row.ours.complex.engine.name.c_str(), row.ours.complex.engine.route.c_str(),
                   row.same() ? "" : "  DIFFERS FROM CGAL")
            << std::flush;
}

const Request& request_of(const Row& r) {
  return r.request;
}

const Column<Row> kColumns[] = {
    {.id = "file",
     .title = "file",
     .help = "The name of the file.",
     .value = [](const Row& r) -> CellValue { return r.file; },
     .files = InFiles::csv},
    {.id = "balls",
     .title = "balls",
     .help = "The number of balls.",
     .value = [](const Row& r) -> CellValue { return static_cast<std::uint64_t>(r.balls); },
     .files = InFiles::csv},
    kRequestedAlpha<Row, request_of>,
    kRequestedSolvent<Row, request_of>,
    {.id = "tetrahedra_only",
     .title = "tetrahedra only",
     .help = "Only tetrahedra were computed.",
     .value = [](const Row& r) -> CellValue { return r.request.tetrahedra_only; },
     .files = InFiles::csv},
    {.id = "threads",
     .title = "threads",
     .help = "The requested number of CPU threads; 0 for all.",
     .value = [](const Row& r) -> CellValue {
       return static_cast<std::uint64_t>(r.request.threads);
     },
     .files = InFiles::csv},
    {.id = "tetrahedra",
     .title = "tetrahedra",
     .help = "The number of tetrahedra of the complex.",
     .value = [](const Row& r) -> CellValue {
       return static_cast<std::uint64_t>(r.ours.tetrahedra);
     },
     .files = InFiles::csv},
    {.id = "hash",
     .title = "hash",
     .help = "The hash of our complex.",
     .value = [](const Row& r) -> CellValue { return hash_text(r.ours.complex.hash); },
     .files = InFiles::csv},
    {.id = "engine",
     .title = "engine",
     .help = "The engine that is compared with CGAL.",
     .value = [](const Row& r) -> CellValue { return r.ours.complex.engine.name; },
     .files = InFiles::csv},
    {.id = "device",
     .title = "device",
     .help = "The device that computed.",
     .value = [](const Row& r) -> CellValue { return r.ours.complex.engine.device; },
     .files = InFiles::csv},
    {.id = "route",
     .title = "route",
     .help = "The way in which this alpha was computed.",
     .value = [](const Row& r) -> CellValue { return r.ours.complex.engine.route; },
     .files = InFiles::csv},
    {.id = "runs",
     .title = "runs",
     .help = "The number of runs of each engine.",
     .value = [](const Row& r) -> CellValue {
       return static_cast<std::uint64_t>(r.ours.cold.size());
     },
     .files = InFiles::csv},
    {.id = "cold_median_ms",
     .title = "cold",
     .unit = "ms",
     .help = "The wall time of a new engine that is made and asked once; the median.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(median(r.ours.cold)); },
     .files = InFiles::csv},
    {.id = "cold_min_ms",
     .title = "least cold",
     .unit = "ms",
     .help = "The least of these times.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(least(r.ours.cold)); },
     .files = InFiles::csv},
    {.id = "warm_median_ms",
     .title = "warm",
     .unit = "ms",
     .help = "The wall time of the same engine, asked again at an alpha smaller by 0.001 Å²; the "
             "median.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(median(r.ours.warm)); },
     .files = InFiles::csv},
    {.id = "cgal_cold_median_ms",
     .title = "CGAL cold",
     .unit = "ms",
     .help = "The cold time of CGAL; the median.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(median(r.cgal.cold)); },
     .files = InFiles::csv},
    {.id = "cgal_cold_min_ms",
     .title = "CGAL least cold",
     .unit = "ms",
     .help = "The least of these times.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(least(r.cgal.cold)); },
     .files = InFiles::csv},
    {.id = "cgal_warm_median_ms",
     .title = "CGAL warm",
     .unit = "ms",
     .help = "The warm time of CGAL; the median.",
     .value = [](const Row& r) -> CellValue { return csv_milliseconds(median(r.cgal.warm)); },
     .files = InFiles::csv},
    {.id = "identical",
     .title = "identical",
     .help = "CGAL has the same hash.",
     .value = [](const Row& r) -> CellValue { return r.same(); },
     .files = InFiles::csv}};
constexpr std::span<const Column<Row>> kAllColumns(kColumns);

CsvRow csv_row(const Row& row) {
  CsvRow csv = csv_row_of(kAllColumns, row);
  for (const auto& entry : row.provenance) {
    if (entry.first != "file") csv.push_back(entry);
  }
  csv.emplace_back("program", program_text());
  return csv;
}

ExitCode run_bench(const BenchOptions& options) {
  if (!options.suite.empty()) return run_thesis_bench(options);
  if (options.alphas.empty()) throw UsageError("--alpha is required, such as --alpha 0,1.4,3");
  if (!options.engines.empty() || !options.rounds.empty() || !options.json.empty() ||
      !options.charts.empty()) {
    throw UsageError("--engines, --rounds, --json and --charts need --suite thesis");
  }
  const RunContext& context = run_context();
  RunContext quiet;  // no progress reports during timing
  quiet.cancel = context.cancel;
  require_readable({options.files.begin(), options.files.end()});
  Outputs outputs(files_read(options.files, {}, options.input));
  AtomicFile* const csv = outputs.add("--csv", options.csv, Outputs::kCsv);
  std::vector<Row> rows;
  bool same = true;
  print_header(options);
  for (const std::string& file : options.files) {
    InputOptions input_options = options.input;
    input_options.file = file;
    for_each_model(input_options, context, [&](const Input& input) {
      clear_progress();
      std::shared_ptr<const BallSet> balls = input.prepared().balls;
      if (options.request.solvent_radius_angstrom != 0) {
        balls = std::make_shared<const BallSet>(
            with_solvent(*balls, options.request.solvent_radius_angstrom));
      }
      for (const int threads : options.threads) {
        for (const Alpha& alpha : options.alphas) {
          Request request = options.request;
          request.alpha_angstrom2 = alpha;
          request.threads = threads;
          const std::string rounding = rounding_note(request, balls->lattice);
          if (!rounding.empty()) print_error(file + ": note: " + rounding);
          rows.push_back(measure(input, balls, request, options.runs, quiet));
          same &= rows.back().same();
          print_row(rows.back());
        }
      }
    });
  }
  if (csv) {
    std::vector<CsvRow> table;
    table.reserve(rows.size());
    for (const Row& row : rows) table.push_back(csv_row(row));
    csv->write(csv_text(table));
  }
  outputs.commit();
  return same ? ExitCode::ok : ExitCode::differs;
}

// The options of --suite thesis alone.
Options thesis_suite(BenchOptions& options) {
  Options suite{
      choice_option({"--suite", "thesis",
                     "The thesis' rounds, and all engines, stages, ablations and figures of its "
                     "chapter 4"},
                    options.suite),
      with_default(choices_option({"--engines", engine_ids(EngineGroup::suite, "|"),
                                   "Engines of the suite, such as cpu,gpu"},
                                  options.engines),
                   "all engines that can run here"),
      number_option({"--seconds", "S",
                     "Time limit for a row; rows that need longer for one run are left out"},
                    options.seconds_per_row, {0.1, 86400, "s"}),
      flag_option("--no-ablation", "Leave out the rows that switch optimisations off",
                  options.ablation, false),
      output("--rounds", "Part I, the thesis' rounds, as CSV; - for standard output",
             options.rounds),
      output("--json", "Both tables as JSON; - for standard output", options.json),
      text_option({"--charts", "DIR", "The figures as SVG, into this folder"}, options.charts)};
  for (Option& option : suite) option.group = "The thesis' table and figures";
  return suite;
}

OptionCommand table_of_bench(BenchOptions& options) {
  OptionCommand command{
      "bench", "Time our engine and CGAL in one process, cold and warm; medians", {}};
  Option files = required(texts_option({"FILE", "FILE", file_text()}, options.files));
  command.options = {files, with_default(alphas(options.alphas, "Alphas in Å², such as -1,0,1.4"),
                                         "with --suite: 0,1.4,3 Å²")};
  append(command.options, engine(options.request, false));
  append(command.options,
         {whole_numbers_option({"--threads", "N", "CPU threads for both, such as 1,2; 0 for all"},
                               options.threads, kThreadRange),
          whole_number_option({"--runs", "N", "Runs of each"}, options.runs, {1, 1000}),
          output("--csv", "The table as CSV; - for standard output", options.csv)});
  append(command.options, input(options.input));
  append(command.options, thesis_suite(options));
  command.check = [&options] { require_tuple_engine(options.request); };
  return command;
}

}  // namespace

std::vector<ColumnInfo> bench_columns() {
  return infos_of(kAllColumns);
}

Command bench_command() {
  Command command = make_command<BenchOptions>(
      table_of_bench, run_bench,
      {"alphascope-cli bench 1k4c.crd.gz --alpha 0,1.4,3 --tetrahedra-only --csv times.csv"});
  command.times_are_the_result = true;
  return command;
}

}  // namespace alphascope::cli
