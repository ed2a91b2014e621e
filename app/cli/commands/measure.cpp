// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli measure: exact area and volume of the union of balls of each file or model.
// Prints totals, components, and values by atom, residue or chain.
#include <algorithm>
#include <iostream>
#include <utility>

#include "app/cli/command.hpp"
#include "app/cli/derived_results.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/engine_cache.hpp"
#include "core/document/measures/measure_json.hpp"
#include "core/document/measures/measure_names.hpp"
#include "core/document/store/inputs.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"

namespace alphascope::cli {
namespace {

struct MeasureCommandOptions {
  InputFiles files;
  InputOptions input;
  Request request;
  MeasureGrouping per = MeasureGrouping::all;
  bool derivatives = false;
  std::string json, csv;
};

struct Answer {
  MeasureFacts facts;
  std::shared_ptr<const UnionDerivatives> derivatives;  // null if not requested
};

Answer measure(const Input& input, const MeasureCommandOptions& options, EngineCache& engines,
               const RunContext& context) {
  Answer answer;
  answer.facts.source = source_of(input);
  const auto complex = std::make_shared<const EngineAnswer>(
      engines.compute(input.prepared().balls, options.request, context));
  answer.facts.answer = complex;
  UnionDerivatives derivatives;
  MeasuredUnion by =
      engines.measure(*complex, context, options.derivatives ? &derivatives : nullptr);
  Inputs inputs = derived_inputs(input, 0, options.request.alpha_angstrom2);
  inputs.balls = complex->balls;  // grown by the solvent radius
  inputs.complex = {complex, &complex->complex};
  inputs.measures = std::make_shared<const MeasuredUnion>(std::move(by));
  answer.facts.measured = make_evaluator().evaluate(union_measures(), inputs, context);
  if (options.derivatives) {
    answer.derivatives = std::make_shared<const UnionDerivatives>(std::move(derivatives));
  }
  return answer;
}

MeasureRows rows_per(MeasureGrouping per, const Answer& answer) {
  return rows_of_measures(answer.facts, {.per = per},
                          per == MeasureGrouping::atom ? answer.derivatives : nullptr);
}

// --- output

std::string components_text(const Answer& answer) {
  const std::uint32_t count = answer.facts.measured->components.count;
  if (count < 2) return grouped(count);
  double largest = 0;
  for (const MeasureRow& row : rows_per(MeasureGrouping::component, answer).rows) {
    largest = std::max(largest, row.share_of_volume);
  }
  return grouped(count) + format_text("; the largest has %.2f %% of the volume", 100 * largest);
}

std::string totals_text(const UnionMeasures& measures) {
  std::string text;
  each_quantity([&](MeasuredQuantity q) {
    const QuantityName name = quantity_name(q);
    text += format_text("%-12s%.6f ", name.word, measures.total[q]) + name.unit + "\n";
  });
  return text;
}

void print(const Input& input, const MeasureCommandOptions& options, const Answer& answer) {
  const Request& request = options.request;
  const EngineAnswer& from = *answer.facts.answer;
  const AlphaComplex& complex = from.complex;
  const MeasuredUnion& by = *answer.facts.measured->by;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << shortest_number(request.alpha_angstrom2) << " Å², solvent radius "
            << shortest_number(request.solvent_radius_angstrom) << " Å\n"
            << "surface     " << surface_name(request) << "\n"
            << totals_text(answer.facts.measures()) << "components  " << components_text(answer)
            << "\n"
            << "hash        " << hash_text(complex.hash) << "\n";
  if (verbosity() != Verbosity::quiet) {
    for (const std::string& note : {from.note, by.note}) {
      if (!note.empty()) std::cout << "note        " << note << "\n";
    }
  }
  if (times_shown()) {
    std::cout << "time        complex " << milliseconds_text(complex.timings.wall_milliseconds)
              << " (" << complex.engine.name << ", " << complex.engine.device << "), measures "
              << milliseconds_text(by.milliseconds) << " (" << by.device
              << (by.route.empty() ? "" : ": " + by.route) << ")\n";
  }
  std::cout << std::flush;
}

void add_rows(CsvResults& csv, const Answer& answer, const MeasureRows& table) {
  const Provenance provenance = provenance_of(answer.facts);
  for (const MeasureRow& row : table.rows) {
    csv.add(measure_csv_row(answer.facts, table, row, provenance));
  }
}

ExitCode run_measure(const MeasureCommandOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv});
  EngineCache engines(&make_engine);
  return command.run([&](const std::string&, const Input& input) {
    const Answer answer = measure(input, options, engines, context);
    const bool tabled = command.json.wanted() || command.csv.wanted();
    const MeasureRows table = tabled ? rows_per(options.per, answer) : MeasureRows{};
    clear_progress();
    if (command.shown()) print(input, options, answer);
    if (command.json.wanted()) command.json.add(measures_json(answer.facts, table));
    if (command.csv.wanted()) add_rows(command.csv, answer, table);
  });
}

OptionCommand table_of_measure(MeasureCommandOptions& options) {
  OptionCommand command{
      "measure", "Exact area and volume of the union of balls, also by chain, residue or atom", {}};
  command.options = many_files(options.files);
  Option alpha = alpha_option("Alpha in Å²; it may be negative", options.request.alpha_angstrom2);
  command.options.push_back(with_default(alpha, "0"));
  append(command.options, engine(options.request, true));
  std::erase_if(command.options, [](const Option& o) { return o.names == "--tetrahedra-only"; });
  Option per{.names = "--per",
             .value = "atom|residue|chain|component",
             .text = "Groups of atoms for the rows of the CSV and for a list in the JSON",
             .fallback = "one row for all atoms"};
  per.set = [&options, choices = per.choices()](const std::string& id) {
    require_choice(id, choices);
    const auto at = std::find(choices.begin(), choices.end(), id) - choices.begin();
    options.per = static_cast<MeasureGrouping>(at + 1);
  };
  append(command.options,
         {per,
          flag_option("--derivatives",
                      "Add the derivatives of area and volume by centre and radius of each atom",
                      options.derivatives),
          output("--json", "Measures, counts, hash and times as JSON; - for standard output",
                 options.json),
          output("--csv", "Measures, one row for each group; - for standard output", options.csv)});
  append(command.options, input(options.input));
  command.check = [&options] {
    require_files(options.files);
    if (options.derivatives && options.per != MeasureGrouping::atom) {
      throw std::invalid_argument("--derivatives gives numbers for atoms: add --per atom");
    }
    require_tuple_engine(options.request);
  };
  return command;
}

}  // namespace

Command measure_command() {
  return make_command<MeasureCommandOptions>(
      table_of_measure, run_measure,
      {"alphascope-cli measure 4hhb.pdb.gz --solvent 1.4 --per residue --csv areas.csv"});
}

}  // namespace alphascope::cli
