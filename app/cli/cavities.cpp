// alphascope-cli cavities: voids and pockets of each file, or of each of its models, as CASTp finds
// them, with their areas, volumes, mouths and lining residues.
#include "app/cli/cavity_answer.hpp"
#include "app/cli/cavity_records.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/terminal.hpp"

namespace alphascope::cli {

ExitCode run_cavities(const CavitiesOptions& options) {
  const RunContext& context = run_context();
  FilesCommand command(options.files, options.input,
                       body_options(options.input, options.body, context),
                       {options.json, options.csv});
  return command.run([&](const std::string&, const Input& as_opened) {
    const Input input = with_body_radii(as_opened, options.input);
    const CavityAnswer answer =
        find_cavities_of(input, options, options.request.solvent_radius_angstrom, context);
    clear_progress();
    if (command.shown()) print_cavities(answer, options);
    if (command.json.wanted()) command.json.add(result_json(answer, options));
    for (const std::size_t row : answer.rows) {
      if (command.csv.wanted()) command.csv.add(csv_row(answer, row, row + 1));
    }
  });
}

}  // namespace alphascope::cli
