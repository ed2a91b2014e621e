// alphascope-cli measure: exact area and volume of the union of balls of each file, or of each of
// its models: in all, of each component, and by atom, residue or chain.
#include <algorithm>
#include <iostream>
#include <utility>

#include "app/cli/commands.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/measure_names.hpp"
#include "core/document/measure_rows.hpp"

namespace alphascope::cli {
namespace {

struct Answer {
  EngineAnswer complex;
  MeasuredComplex measured;
  std::shared_ptr<const UnionDerivatives> derivatives;  // null unless asked for

  const UnionMeasures& measures() const { return measured.measures(); }
};

Answer measure(const Input& input, const MeasureCommandOptions& options, EngineCache& engines,
               const RunContext& context) {
  Answer answer;
  answer.complex = engines.compute(input.prepared().balls, options.request, context);
  UnionDerivatives derivatives;
  MeasuredUnion by =
      engines.measure(answer.complex, context, options.derivatives ? &derivatives : nullptr);
  answer.measured = measure_complex(*answer.complex.balls, answer.complex.complex,
                                    std::make_shared<const MeasuredUnion>(std::move(by)), context);
  if (options.derivatives) {
    answer.derivatives = std::make_shared<const UnionDerivatives>(std::move(derivatives));
  }
  return answer;
}

MeasureRows rows_per(const Input& input, MeasuredPer per, const Answer& answer) {
  return make_measure_rows({.per = per}, input.molecule(), input.prepared().atom_of_ball,
                           answer.measured,
                           per == MeasuredPer::atom ? answer.derivatives : nullptr);
}

// --- output

std::string components_text(const Input& input, const Answer& answer) {
  const std::uint32_t count = answer.measured.components.count;
  if (count < 2) return grouped(count);
  double largest = 0;
  for (const MeasureRow& row : rows_per(input, MeasuredPer::component, answer).rows) {
    largest = std::max(largest, row.share_of_volume);
  }
  return grouped(count) + format_text("; the largest has %.2f %% of the volume", 100 * largest);
}

void print(const Input& input, const MeasureCommandOptions& options, const Answer& answer) {
  const Request& request = options.request;
  const AlphaComplex& complex = answer.complex.complex;
  const MeasuredUnion& by = *answer.measured.by;
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
            << number_text(request.solvent_radius_angstrom) << " Å\n"
            << "surface     " << surface_name(request) << "\n"
            << "area        " << format_text("%.6f", answer.measures().area_angstrom2) << " Å²\n"
            << "volume      " << format_text("%.6f", answer.measures().volume_angstrom3) << " Å³\n"
            << "components  " << components_text(input, answer) << "\n"
            << "hash        " << hash_text(complex.hash) << "\n";
  if (verbosity() != Verbosity::quiet) {
    for (const std::string& note : {answer.complex.note, by.note}) {
      if (!note.empty()) std::cout << "note        " << note << "\n";
    }
    std::cout << "time        complex " << milliseconds_text(complex.timings.wall_milliseconds)
              << " (" << complex.engine.name << ", " << complex.engine.device << "), measures "
              << milliseconds_text(by.milliseconds) << " (" << by.device
              << (by.route.empty() ? "" : ": " + by.route) << ")\n";
  }
  std::cout << std::flush;
}

void add_rows(CsvResults& csv, const Input& input, const Request& request, const Answer& answer,
              const MeasureRows& table) {
  const Provenance provenance = input.provenance();
  for (const MeasureRow& measured : table.rows) {
    CsvRow row{{"model", model_text(input.balls.model)},
               {"group", measured.name},
               {"atoms", std::to_string(measured.atoms)}};
    for (const auto& [name, value] : measure_values(table, measured)) {
      row.emplace_back(name, all_digits(value));
    }
    row.emplace_back("surface", surface_name(request));
    row.emplace_back("measured_by", answer.measured.by->device);
    row.emplace_back("alpha_angstrom2", number_text(request.alpha_angstrom2));
    row.emplace_back("solvent_radius_angstrom", number_text(request.solvent_radius_angstrom));
    row.emplace_back("hash", hash_text(answer.complex.complex.hash));
    for (const auto& [key, value] : provenance) {
      if (key != "model") row.emplace_back(key, value);
    }
    row.emplace_back("program", program_text());
    csv.add(row);
  }
}

Json json_of(const MeasureRows& table) {
  Json groups = Json::array();
  for (const MeasureRow& row : table.rows) {
    Json group{{"name", row.name}, {"atoms", row.atoms}};
    for (const auto& [name, value] : measure_values(table, row)) group[name] = value;
    groups.push_back(std::move(group));
  }
  return groups;
}

Json result_json(const Input& input, const MeasureCommandOptions& options, const Answer& answer,
                 const MeasureRows& table) {
  const MeasuredUnion& by = *answer.measured.by;
  Json json{{"surface", surface_name(options.request)},
            {"area_angstrom2", answer.measures().area_angstrom2},
            {"volume_angstrom3", answer.measures().volume_angstrom3},
            {"components", json_of(rows_per(input, MeasuredPer::component, answer))}};
  if (options.per == MeasuredPer::atom) json["atoms"] = json_of(table);
  if (options.per == MeasuredPer::residue) json["residues"] = json_of(table);
  if (options.per == MeasuredPer::chain) json["chains"] = json_of(table);
  json["measured"] = {
      {"device", by.device}, {"route", by.route}, {"note", by.note}, {"ms", by.milliseconds}};
  json.update(complex_json(answer.complex.complex, answer.complex.note));
  json["request"] = request_json(options.request, answer.complex.balls->lattice);
  json["input"] = input_json(input);
  return json;
}

}  // namespace

ExitCode run_measure(const MeasureCommandOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input, open_options(options.input, context),
                       {options.json, options.csv});
  EngineCache engines(&make_engine);
  return command.run([&](const std::string&, const Input& input) {
    const Answer answer = measure(input, options, engines, context);
    const bool tabled = command.json.wanted() || command.csv.wanted();
    const MeasureRows table = tabled ? rows_per(input, options.per, answer) : MeasureRows{};
    clear_progress();
    if (command.shown()) print(input, options, answer);
    if (command.json.wanted()) command.json.add(result_json(input, options, answer, table));
    if (command.csv.wanted()) add_rows(command.csv, input, options.request, answer, table);
  });
}

}  // namespace alphascope::cli
