// alphascope-cli cavities: voids and pockets of each file, or of each of its models, as CASTp finds
// them, with their areas, volumes, mouths and lining residues.
#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/cavities/cavity_comparison.hpp"
#include "app/cli/cavities/cavity_exports.hpp"
#include "app/cli/cavities/cavity_records.hpp"
#include "app/cli/files_command.hpp"
#include "app/cli/text/terminal.hpp"
#include "core/document/settings/cavity_preset.hpp"

namespace alphascope::cli {
namespace {

InputOptions with_radii(InputOptions options, const std::string& radii) {
  options.radii = radii;
  return options;
}

// The molecule with another radii set. Of several sets all must have the same atoms: united-atom
// sets leave out hydrogens, so all do.
Input with_radii(Input input, const InputOptions& of, const CavitiesOptions& options) {
  if (!options.compares()) return with_body_radii(std::move(input), of);
  BallOptions balls = body_options(of, options.body, run_context()).balls;
  balls.model = input.balls.model;
  if (of.radii == "auto") balls.radii = cavity_body({}, input.molecule().has_file_radii).radii;
  if (balls.hydrogens == HydrogenRule::automatic) balls.hydrogens = HydrogenRule::drop;
  input.balls = balls;
  input.opened.prepared = std::make_shared<const PreparedBalls>(
      prepare_balls(input.molecule(), input.balls, run_context()));
  return input;
}

void require_same_atoms(const CavityAnswer& first, const CavityAnswer& other) {
  if (first.input.prepared().atom_of_ball == other.input.prepared().atom_of_ball) return;
  throw UsageError(first.input.molecule().source.string() + ": the radii " + variant_text(first) +
                   " and " + variant_text(other) +
                   " are not of the same atoms, so their cavities cannot be matched. Compare "
                   "sets that have a radius for every atom.");
}

std::vector<CavityAnswer> answers_of(const Input& as_opened, const CavitiesOptions& options) {
  std::vector<CavityAnswer> answers;
  for (const std::string& radii : options.radii) {
    const InputOptions of = with_radii(options.input, radii);
    const Input input = with_radii(as_opened, of, options);
    for (const double solvent : options.solvents) {
      answers.push_back(find_cavities_of(input, options, solvent, run_context()));
      require_same_atoms(answers.front(), answers.back());
    }
  }
  return answers;
}

}  // namespace

ExitCode run_cavities(const CavitiesOptions& options) {
  const RunContext& context = run_context();
  const InputOptions first = with_radii(options.input, options.radii.front());
  FilesCommand command(options.files, first, body_options(first, options.body, context),
                       {options.json, options.csv});
  CavityExports exports(options, command.outputs);
  return command.run([&](const std::string&, const Input& as_opened) {
    exports.shapes().require_openable(as_opened.molecule());
    const CavityComparison all(answers_of(as_opened, options), context);
    const CavityAnswer& answer = all.answers().front();
    exports.write(answer, context);
    clear_progress();
    if (command.shown()) {
      options.compares() ? print_comparison(all, options) : print_cavities(answer, options);
    }
    if (command.json.wanted()) {
      command.json.add(options.compares() ? comparison_json(all, options)
                                          : result_json(answer, options));
    }
    if (!command.csv.wanted()) return;
    for (std::size_t n = 0; n < all.answers().size(); ++n) {
      for (const std::size_t row : all.answers()[n].rows) {
        command.csv.add(cavity_csv(all.answers()[n], row, all.first_id(n, row)));
      }
    }
  });
}

}  // namespace alphascope::cli
