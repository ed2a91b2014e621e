// alphascope-cli compute: one complex, or one for each model, its numbers, and its simplices in a
// file.
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "core/io/csv.hpp"

namespace alphascope::cli {
namespace {

// Counts, or "" for what a tetrahedra-only complex does not hold.
template <class List>
std::string count_text(const AlphaComplex& complex, const List& list) {
  return complex.tetrahedra_only ? "" : std::to_string(list.size());
}

CsvRow csv_row(const Input& input, const SessionRequest& request, const AlphaComplex& complex) {
  CsvRow row{{"model", model_text(input.balls.model)},
             {"balls", std::to_string(input.prepared().balls->size())},
             {"alpha_angstrom2", number_text(request.alpha_angstrom2)},
             {"solvent_radius_angstrom", number_text(request.solvent_radius_angstrom)},
             {"tetrahedra_only", complex.tetrahedra_only ? "1" : "0"},
             {"vertices", count_text(complex, complex.vertices)},
             {"edges", count_text(complex, complex.edges)},
             {"triangles", count_text(complex, complex.triangles)},
             {"tetrahedra", std::to_string(complex.tetrahedra.size())},
             {"euler_characteristic",
              complex.tetrahedra_only ? "" : std::to_string(complex.euler_characteristic())},
             {"hash", hash_text(complex.hash)},
             {"engine", complex.engine.name},
             {"device", complex.engine.device},
             {"route", complex.engine.route},
             {"wall_ms", csv_milliseconds(complex.timings.wall_milliseconds)}};
  for (auto& [key, value] : input.provenance()) {
    if (key != "model") row.emplace_back(key, std::move(value));
  }
  row.emplace_back("program", program_text());
  return row;
}

void print_one(const Input& input, const SessionRequest& request,
               const EngineCache::Result& result) {
  std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
            << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
            << number_text(request.solvent_radius_angstrom) << " Å\n"
            << complex_text(result.complex);
  if (!result.note.empty()) std::cout << "note        " << result.note << "\n";
}

// One line a model, under a heading at the first.
void print_line(const Input& input, const SessionRequest& request,
                const EngineCache::Result& result) {
  const AlphaComplex& complex = result.complex;
  if (input.balls.model == 0) {
    std::cout << input_text(input) << "sha256      " << input.molecule().sha256 << "\n"
              << "alpha       " << number_text(request.alpha_angstrom2) << " Å², solvent radius "
              << number_text(request.solvent_radius_angstrom) << " Å\n";
    std::cout << format_text("%6s %9s %9s %9s %9s %10s %7s  %-16s %s\n", "model", "balls",
                             "vertices", "edges", "triangles", "tetrahedra", "Euler", "hash",
                             "time");
  }
  const auto count = [&](const auto& list) {
    return complex.tetrahedra_only ? std::string("-") : grouped(list.size());
  };
  std::cout << format_text(
                   "%6s %9s %9s %9s %9s %10s %7s  %-16s %s\n",
                   model_text(input.balls.model).c_str(),
                   grouped(input.prepared().balls->size()).c_str(), count(complex.vertices).c_str(),
                   count(complex.edges).c_str(), count(complex.triangles).c_str(),
                   grouped(complex.tetrahedra.size()).c_str(),
                   complex.tetrahedra_only ? "-"
                                           : std::to_string(complex.euler_characteristic()).c_str(),
                   hash_text(complex.hash).c_str(),
                   milliseconds_text(complex.timings.wall_milliseconds).c_str())
            << std::flush;
}

Json result_json(const Input& input, const SessionRequest& request,
                 const EngineCache::Result& result) {
  Json json = complex_json(result.complex, result.note);
  json["request"] = request_json(request, result.balls->lattice);
  json["input"] = input_json(input);
  return json;
}

}  // namespace

ExitCode run_compute(const ComputeOptions& options) {
  const RunContext& context = run_context();
  const SessionRequest& request = options.request;
  const bool each = each_model(options.input);
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  AtomicFile* const out = outputs.add("--out", options.out);
  AtomicFile* const csv = outputs.add("--csv", options.csv);
  AtomicFile* const json = outputs.add("--json", options.json);
  EngineCache engines(&make_engine);
  Json results = Json::array();
  std::vector<CsvRow> rows;
  for_each_model(options.input, context, [&](const Input& input) {
    const EngineCache::Result result = engines.compute(input.prepared().balls, request, context);
    if (out) {
      write_complex_text(*result.balls, result.complex, complex_header(input, request, result),
                         *out, context);
    }
    clear_progress();
    (each ? print_line : print_one)(input, request, result);
    if (json) results.push_back(result_json(input, request, result));
    if (csv) rows.push_back(csv_row(input, request, result.complex));
  });
  if (csv) csv->write(csv_text(rows));
  if (json) {
    Json whole = each ? Json{{"models", std::move(results)}} : std::move(results[0]);
    whole["program"] = program_json();
    json->write(json_text(whole));
  }
  outputs.commit();
  return ExitCode::ok;
}

}  // namespace alphascope::cli
