// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli compute: prints the numbers of each file's or model's complex, and writes its
// simplices to a file.
#include <cstdint>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/commands/columns.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/table.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/engine_cache.hpp"
#include "app/session/rounding_note.hpp"
#include "app/session/system_memory.hpp"
#include "core/complex/own_dimension.hpp"
#include "core/document/settings/request_columns.hpp"
#include "core/molecule/molecule.hpp"
#include "core/write/write_filtration.hpp"

namespace alphascope::cli {
namespace {

struct ComputeOptions {
  InputFiles files;
  InputOptions input;
  Request request;
  std::string json, csv, out, filtration;
};

// A row of the CSV.
struct Computed {
  const Input& input;
  const EngineAnswer& result;

  const AlphaComplex& complex() const { return result.complex; }
  // Returns no value for a list that is not computed with --tetrahedra-only.
  template <class List>
  CellValue count_of(const List& list) const {
    if (complex().tetrahedra_only) return {};
    return static_cast<std::uint64_t>(list.size());
  }
};

const Request& request_of(const Computed& r) {
  return r.result.request;
}

const Column<Computed> kColumns[] = {
    {.id = "model",
     .title = "model",
     .help = "The model of the file, from 1; “joined” for all models as one.",
     .value = [](const Computed& r) -> CellValue { return model_text(r.input.balls.model); },
     .files = InFiles::csv},
    {.id = "balls",
     .title = "balls",
     .help = "The number of balls.",
     .value = [](const Computed& r) -> CellValue {
       return static_cast<std::uint64_t>(r.input.prepared().balls->size());
     },
     .files = InFiles::csv},
    kRequestedAlpha<Computed, request_of>,
    kRequestedSolvent<Computed, request_of>,
    {.id = "solvent_rounding_angstrom",
     .title = "rounding",
     .unit = "Å",
     .help =
         "The change of the solvent radius to a multiple of the lattice unit; 0 if it is exact.",
     .value = [](const Computed& r) -> CellValue {
       return shortest_number(solvent_rounding_angstrom(r.result.request, r.complex().lattice));
     },
     .files = InFiles::csv},
    {.id = "tetrahedra_only",
     .title = "tetrahedra only",
     .help = "Only tetrahedra were computed.",
     .value = [](const Computed& r) -> CellValue { return r.complex().tetrahedra_only; },
     .files = InFiles::csv},
    {.id = "vertices",
     .title = "vertices",
     .help = "The number of vertices; empty if only tetrahedra were computed.",
     .value = [](const Computed& r) -> CellValue { return r.count_of(r.complex().vertices); },
     .files = InFiles::csv},
    {.id = "edges",
     .title = "edges",
     .help = "The number of edges; empty if only tetrahedra were computed.",
     .value = [](const Computed& r) -> CellValue { return r.count_of(r.complex().edges); },
     .files = InFiles::csv},
    {.id = "triangles",
     .title = "triangles",
     .help = "The number of triangles; empty if only tetrahedra were computed.",
     .value = [](const Computed& r) -> CellValue { return r.count_of(r.complex().triangles); },
     .files = InFiles::csv},
    {.id = "tetrahedra",
     .title = "tetrahedra",
     .help = "The number of tetrahedra.",
     .value = [](const Computed& r) -> CellValue {
       return static_cast<std::uint64_t>(r.complex().tetrahedra.size());
     },
     .files = InFiles::csv},
    {.id = "euler_characteristic",
     .title = "Euler characteristic",
     .help = "V − E + F − T; empty if only tetrahedra were computed.",
     .value = [](const Computed& r) -> CellValue {
       return r.complex().tetrahedra_only ? "" : std::to_string(r.complex().euler_characteristic());
     },
     .files = InFiles::csv},
    {.id = "hash",
     .title = "hash",
     .help = "The set of simplices as 16 hexadecimal digits, the same on every engine.",
     .value = [](const Computed& r) -> CellValue { return hash_text(r.complex().hash); },
     .files = InFiles::csv},
    {.id = "engine",
     .title = "engine",
     .help = "The engine that computed.",
     .value = [](const Computed& r) -> CellValue { return r.complex().engine.name; },
     .files = InFiles::csv},
    {.id = "device",
     .title = "device",
     .help = "The device that computed.",
     .value = [](const Computed& r) -> CellValue { return r.complex().engine.device; },
     .files = InFiles::csv},
    {.id = "route",
     .title = "route",
     .help = "The way in which this alpha was computed.",
     .value = [](const Computed& r) -> CellValue { return r.complex().engine.route; },
     .files = InFiles::csv},
    {.id = "wall_ms",
     .title = "wall time",
     .unit = "ms",
     .help = "The wall time.",
     .value = [](const Computed& r) -> CellValue {
       return csv_milliseconds(r.complex().timings.wall_milliseconds);
     },
     .files = InFiles::csv}};
constexpr std::span<const Column<Computed>> kAllColumns(kColumns);

CsvRow csv_row(const Input& input, const EngineAnswer& result) {
  const AlphaComplex& complex = result.complex;
  CsvRow row = csv_row_of(kAllColumns, {input, result});
  for (auto& [key, value] : input.provenance()) {
    // The lattice is that of the complex, since the solvent radius may need a finer one than the
    // molecule.
    if (key == "lattice_unit_angstrom") value = lattice_unit_text(complex.lattice);
    if (key != "model") row.emplace_back(key, std::move(value));
  }
  row.emplace_back("program", program_text());
  return row;
}

std::string request_text(const Request& request) {
  return "alpha       " + shortest_number(request.alpha_angstrom2) + " Å², solvent radius " +
         shortest_number(request.solvent_radius_angstrom) + " Å\n";
}

// Returns the lines that --verbose adds to a result.
std::string effort_text(const Input& input) {
  return "opened in   " + milliseconds_text(input.open_milliseconds) + "\nmemory      " +
         grouped(resident_bytes() / 1'000'000) + " MB in use by the program\n";
}

// Prints a result without flushing it. The files are completed before that, so a reader that stops
// early, such as `head`, loses no file.
void print_one(const Input& input, const EngineAnswer& result) {
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << request_text(result.request) << complex_text(result.complex);
  if (!result.note.empty() && verbosity() != Verbosity::quiet) {
    std::cout << "note        " << result.note << "\n";
  }
  if (verbosity() == Verbosity::verbose && times_shown()) std::cout << effort_text(input);
}

// Prints one line a result, under a heading before the first.
class ResultTable {
 public:
  // `files`: names as given. The name of a single file stands above the table.
  ResultTable(const std::vector<std::string>& files, bool many, bool models)
      : many_(many), models_(models), table_(columns(files, many, models)) {}

  void print(const std::string& file, const Input& input, const EngineAnswer& result) {
    const std::string rounding = rounding_note(result.request, result.complex.lattice);
    if (!begun_) {
      print_heading(input, result);
    } else if (!rounding.empty() && verbosity() != Verbosity::quiet) {
      print_error(file + ": note: " + rounding);
    }
    begun_ = true;
    // The notes of a single file stand above the table.
    if (many_ && verbosity() != Verbosity::quiet) {
      for (const std::string& note : input_notes(input)) print_error(file + ": note: " + note);
    }
    std::cout << table_.line(cells(file, input, result.complex));
    if (verbosity() == Verbosity::verbose && times_shown()) {
      std::cout << effort_text(input) << stages_text(result.complex);
    }
    std::cout << std::flush;
  }

 private:
  static std::vector<TableColumn> columns(const std::vector<std::string>& files, bool many,
                                          bool models) {
    std::vector<TableColumn> columns;
    if (many) columns.push_back({"file", widest(files), true});
    if (models) columns.push_back({"model", 6});
    for (const char* count : {"balls", "vertices", "edges", "triangles", "tetrahedra"}) {
      columns.push_back({count, 9});
    }
    columns.push_back({"Euler", 7});
    columns.push_back({"hash", 16, true});
    if (times_shown()) columns.push_back({"time", 8});
    return columns;
  }

  void print_heading(const Input& input, const EngineAnswer& result) {
    if (!many_) std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n";
    std::cout << request_text(result.request);
    if (many_ && !result.note.empty() && verbosity() != Verbosity::quiet) print_error(result.note);
    std::cout << table_.heading();
  }

  std::vector<std::string> cells(const std::string& file, const Input& input,
                                 const AlphaComplex& complex) const {
    const auto count = [&](const auto& list) {
      return complex.tetrahedra_only ? std::string("-") : grouped(list.size());
    };
    std::vector<std::string> cells;
    if (many_) cells.push_back(file);
    if (models_) cells.push_back(model_text(input.balls.model));
    cells.insert(
        cells.end(),
        {grouped(input.prepared().balls->size()), count(complex.vertices), count(complex.edges),
         count(complex.triangles), grouped(complex.tetrahedra.size()),
         complex.tetrahedra_only ? "-" : std::to_string(complex.euler_characteristic()),
         hash_text(complex.hash)});
    if (times_shown()) cells.push_back(milliseconds_text(complex.timings.wall_milliseconds));
    return cells;
  }

  bool many_, models_, begun_ = false;
  Table table_;
};

Json result_json(const Input& input, const EngineAnswer& result) {
  Json json = complex_json(result.complex, result.note);
  json["request"] = request_json(result.request, result.balls->lattice);
  json["input"] = input_json(input, result.balls->lattice);
  return json;
}

ExitCode run_compute(const ComputeOptions& options) {
  const RunContext& context = run_context();
  const Request& request = options.request;
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv, options.out});
  AtomicFile* const filtration =
      command.outputs.add("--filtration", options.filtration, Outputs::kText);
  const bool print = command.shown(), table_only = command.many || command.each_model;
  ResultTable table(command.files, command.many, command.each_model);
  EngineCache engines(&make_engine);
  return command.run([&](const std::string& file, const Input& input) {
    const EngineAnswer result = engines.compute(input.prepared().balls, request, context);
    if (command.out) {
      const InOwnDimension own(*result.balls, result.complex);
      write_complex_text(*result.balls, own.complex(), complex_header(input, result), *command.out,
                         context);
    }
    if (filtration) {
      write_filtration_text(result.balls, result.complex, complex_header(input, result),
                            *filtration, context);
    }
    clear_progress();
    if (print && table_only) table.print(file, input, result);
    if (print && !table_only) print_one(input, result);
    if (command.json.wanted()) command.json.add(result_json(input, result));
    if (command.csv.wanted()) command.csv.add(csv_row(input, result));
  });
}

OptionCommand table_of_compute(ComputeOptions& options) {
  OptionCommand command{"compute", "Compute the alpha complex of each file", {}};
  command.options = many_files(options.files);
  command.options.push_back(alpha(options.request));
  append(command.options, engine(options.request, true));
  append(command.options, input(options.input));
  append(command.options,
         {output("--json", "Counts, hash, times and provenance as JSON; - for standard output",
                 options.json),
          output("--csv",
                 "Counts and provenance, one row for each file and model; - for standard output",
                 options.csv),
          output("--out", "All simplices with their alpha values, as text", options.out),
          output("--filtration",
                 "All simplices in the order in which a growing alpha reaches them, as text, with "
                 "the alphas from which they are regular and interior",
                 options.filtration)});
  command.check = [&options] {
    require_files(options.files);
    if (!options.filtration.empty() && options.request.tetrahedra_only) {
      throw UsageError("--filtration needs all simplices; leave out --tetrahedra-only");
    }
    require_tuple_engine(options.request);
  };
  return command;
}

}  // namespace

std::vector<ColumnInfo> compute_columns() {
  return infos_of(kAllColumns);
}

Command compute_command() {
  return make_command<ComputeOptions>(
      table_of_compute, run_compute,
      {"alphascope-cli compute 1crn.pdb --alpha 0 --solvent 1.4 --json 1crn.json",
       "alphascope-cli compute 1k4c.crd.gz --alpha 1.4 --out 1k4c.alpha",
       "alphascope-cli compute 1d3z.cif.gz --model all --alpha 0 --solvent 1.4 --csv models.csv",
       "alphascope-cli compute pdb/*.pdb.gz --alpha 0 --solvent 1.4 --csv all.csv",
       "zcat 1crn.pdb.gz | alphascope-cli compute - --alpha 1.4"});
}

}  // namespace alphascope::cli
