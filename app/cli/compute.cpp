// alphascope-cli compute: one complex, its numbers, and its simplices in a file.
#include <iostream>
#include <optional>

#include "app/cli/commands.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"

namespace alphascope::cli {

ExitCode run_compute(const ComputeOptions& options) {
  const RunContext& context = run_context();
  const Input input = open_input(options.input, context);
  // Opened first: that it cannot be written should not show only after hours of computing.
  std::optional<AtomicFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  EngineCache engines(&make_engine);
  const EngineCache::Result result =
      engines.compute(input.prepared().balls, options.request, context);
  if (out) {
    write_complex_text(*result.balls, result.complex,
                       complex_header(input, options.request, result.complex), *out, context);
    out->commit();
  }
  clear_progress();
  if (options.json != "-") {
    std::cout << input_text(input) << "alpha       "
              << number_text(options.request.alpha_angstrom2) << " Å², solvent radius "
              << number_text(options.request.solvent_radius_angstrom) << " Å\n"
              << complex_text(result.complex);
    if (!result.note.empty()) std::cout << "note        " << result.note << "\n";
    std::cout << std::flush;
  }
  if (!options.json.empty()) {
    Json json = complex_json(result.complex, result.note);
    json["request"] = request_json(options.request, result.balls->lattice);
    json["input"] = input_json(input);
    json["program"] = program_json();
    write_json(json, options.json);
  }
  return ExitCode::ok;
}

}  // namespace alphascope::cli
