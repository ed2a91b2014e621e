// SPDX-License-Identifier: GPL-3.0-or-later
// JSON objects of program, input and comparison.
#include "app/cli/report_json.hpp"

#include "app/cli/text/terminal.hpp"
#include "app/session/result_header.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope::cli {

ProgramName program() {
  return program_named("alphascope-cli");
}

std::string program_text() {
  return program().text();
}

Json program_json() {
  return alphascope::program_json(program());
}

RecordSource source_of(const Input& input) {
  return {input.opened.molecule, input.opened.prepared, input.balls, program(),
          input.open_milliseconds};
}

Json input_json(const Input& input, const Lattice& computed_on) {
  return alphascope::input_json(source_of(input).on(computed_on));
}

Json json_to_write(Json json) {
  if (!times_wanted()) leave_out_run(json);
  return json;
}

Json comparison_json(const Comparison& comparison) {
  const auto set = [](const auto& difference) {
    return Json{{"common", difference.common},
                {"missing", difference.missing},
                {"extra", difference.extra}};
  };
  Json json{{"identical", comparison.identical()},
            {"tetrahedra_only", comparison.tetrahedra_only},
            {"both_rest_on_cgal", comparison.both_rest_on_cgal}};
  if (!comparison.tetrahedra_only) {
    json["vertices"] = set(comparison.vertices);
    json["edges"] = set(comparison.edges);
    json["triangles"] = set(comparison.triangles);
    json["alpha_values_differing"] = comparison.alpha_values_differing;
    json["classes_differing"] = comparison.classes_differing;
  }
  json["tetrahedra"] = set(comparison.tetrahedra);
  return json;
}

ComplexHeader complex_header(const Input& input, const EngineAnswer& answer) {
  ComplexHeader header =
      result_header("alphascope-cli", input.provenance(), input.molecule().notes, answer);
  for (auto& [key, value] : header) {
    if (key == "engine" && !times_wanted()) value = answer.complex.engine.name;
  }
  return header;
}

}  // namespace alphascope::cli
