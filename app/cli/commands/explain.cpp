// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli explain: says why a simplex is or is not in the alpha complex.
#include <iostream>

#include "app/cli/command.hpp"
#include "app/cli/derived_results.hpp"
#include "app/cli/failure.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/text/sentences.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/option_values.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/explain/explanation_json.hpp"
#include "core/document/explain/explanation_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

struct ExplainOptions {
  InputOptions input;
  std::vector<int> simplex;  // 1 to 4 different balls, from 0; empty if `atoms` is given
  std::string atoms;         // 1 to 4 balls by address or expression
  std::optional<Alpha> alpha_angstrom2;
  double solvent_radius_angstrom = 0;
  std::string json;
};

using Balls = std::vector<BallIndex>;

Balls simplex_by_atoms(const BallReferences& atoms, const std::string& text) {
  const AddressedBalls named = balls_by_address(atoms, "--atoms", text);
  if (named.balls.empty() || named.balls.size() > 4) {
    throw UsageError("--atoms names " + grouped(named.balls.size()) +
                     " atoms that are balls: a simplex has 1 to 4." + named.note_on_others());
  }
  return named.balls;
}

Balls simplex_of(const Input& input, const ExplainOptions& options) {
  const BallReferences atoms(input.opened.molecule, input.opened.prepared);
  if (!options.atoms.empty()) return simplex_by_atoms(atoms, options.atoms);
  Balls simplex;
  for (const int index : options.simplex)
    simplex.push_back(ball_by_index(input, "--simplex", index));
  return simplex;
}

Json result_json(const Input& input, const Request& request, const Explanation& e,
                 const BallName& name) {
  Json json = explanation_json(e, name);
  json["request"] = {{"solvent_radius_angstrom", request.solvent_radius_angstrom},
                     {"lattice_unit_angstrom", e.lattice.unit_angstrom()}};
  json["input"] = input_json(input, e.lattice);
  json["program"] = program_json();
  return json;
}

ExitCode run_explain(const ExplainOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  JsonResults json(outputs.add("--json", options.json, Outputs::kJson), "");
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  const Input input = open_one_model(options.input, "explain takes one model.", context);
  const Balls simplex = simplex_of(input, options);
  Request request;
  request.solvent_radius_angstrom = options.solvent_radius_angstrom;
  if (options.alpha_angstrom2) request.alpha_angstrom2 = *options.alpha_angstrom2;
  const Inputs inputs = derived_inputs(input, options.solvent_radius_angstrom,
                                       options.alpha_angstrom2.value_or(kNoAlpha));
  std::shared_ptr<const ExplainedSimplex> explained;
  WorkThreads threads(1);
  const double milliseconds = timed([&] {
    threads.run([&] {
      explained = make_evaluator().evaluate(explained_simplex(simplex), inputs, context);
    });
  });
  const Explanation& e = explained->explanation;
  const BallName name = [&](BallIndex ball) { return atom_text(*inputs.atoms, ball); };
  clear_progress();
  if (shown) {
    std::cout << input_text(input);
    for (const ExplanationLine& line : explained->lines) print_line(std::cout, line);
    const std::string note = rounding_note(request, inputs.balls->lattice);
    if (!note.empty()) print_line(std::cout, {"Note", note});
    if (times_shown()) {
      print_line(std::cout, {"Time", milliseconds_text(milliseconds)});
    }
    std::cout << std::flush;
  }
  if (json.wanted()) json.add(result_json(input, request, e, name));
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

Option optional_alpha(std::optional<Alpha>& alpha) {
  Option option{.names = "--alpha",
                .value = "A",
                .text = "Alpha in Å² of the complex that the simplex is compared with",
                .fallback = "none: every alpha"};
  option.set = [&alpha](const std::string& value) { alpha = alpha_in(value); };
  return option;
}

void require_simplex(const std::vector<int>& simplex) {
  if (simplex.size() > 4) {
    throw std::invalid_argument("--simplex has " + std::to_string(simplex.size()) +
                                " balls; a simplex has 1 to 4");
  }
  for (auto at = simplex.begin(); at != simplex.end(); ++at) {
    if (std::find(simplex.begin(), at, *at) != at) {
      throw std::invalid_argument("--simplex names ball " + std::to_string(*at) +
                                  " twice: give each ball once");
    }
  }
}

OptionCommand table_of_explain(ExplainOptions& options) {
  OptionCommand command{
      "explain",
      "Explain why a vertex, edge, triangle or tetrahedron is in the complex, or not",
      {}};
  command.options = {
      one_file(options.input),
      whole_numbers_option({"--simplex", "I,J,K,L",
                            "One to four balls by number, counted from 0 in the order of the atoms "
                            "used, as in the files of compute"},
                           options.simplex, {0, 2'147'483'647}),
      text_option({"--atoms", "ATOMS",
                   "One to four balls by name: addresses such as A:HIS 87:NE2,A:HIS 87:CE1, or an "
                   "expression as for --select"},
                  options.atoms),
      optional_alpha(options.alpha_angstrom2),
      number_option({"--solvent", "S", "Solvent radius in Å, added to every radius"},
                    options.solvent_radius_angstrom, kSolventRange),
      output("--json", "The explanation as JSON; - for standard output", options.json)};
  append(command.options, input(options.input));
  command.check = [&options] {
    if (options.simplex.empty() == options.atoms.empty()) {
      throw std::invalid_argument("give --simplex I,J,K,L or --atoms ATOMS");
    }
    require_simplex(options.simplex);
  };
  return command;
}

}  // namespace

Command explain_command() {
  return make_command<ExplainOptions>(
      table_of_explain, run_explain,
      {"alphascope-cli explain 1crn.pdb --simplex 3,4,7 --alpha 1.4"});
}

}  // namespace alphascope::cli
