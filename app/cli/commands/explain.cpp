// alphascope-cli explain: why a simplex is in the alpha complex, or not.
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/derived_results.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/text/sentences.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/document/explain/explanation_json.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/explain/explanation_results.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

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

}  // namespace

ExitCode run_explain(const ExplainOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  JsonResults json(outputs.add("--json", options.json, Outputs::kJson), "");
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  const Input input = open_one_model(options.input, "A simplex is one model's.", context);
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

}  // namespace alphascope::cli
