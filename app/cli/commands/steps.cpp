// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli steps: prints step by step how an engine finds the simplices of one ball.
#include <algorithm>
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
#include "core/document/explain/steps_json.hpp"
#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

struct StepsOptions {
  InputOptions input;
  std::string ball;  // its index from 0, or an address
  std::string engine = "tuples";
  Request request;  // alpha, solvent radius and the switches of the tuple engine
  std::string json;
};

BallIndex ball_of(const Input& input, const BallReferences& atoms, const std::string& text) {
  const bool is_number =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (is_number && text.size() < 10) return ball_by_index(input, "--ball", std::stoi(text));
  const AddressedBalls named = balls_by_address(atoms, "--ball", text);
  if (named.balls.size() != 1) {
    throw UsageError("--ball \"" + text + "\" names " + grouped(named.balls.size()) +
                     " atoms that are balls: name one, such as \"A:HIS 87:NE2\", or give its "
                     "number." +
                     named.note_on_others());
  }
  return named.balls.front();
}

void print_steps(const ExplainedSteps& told) {
  for (std::size_t n = 0; n < told.texts.size(); ++n) {
    std::cout << n + 1 << ". " << told.texts[n].title << ": " << told.texts[n].brief << "\n";
    print_line(std::cout, {"", told.texts[n].text});
  }
  print_line(std::cout, {"Saturation", told.saturation_text});
}

Json result_json(const Input& input, const StepsOptions& options, const ExplainedSteps& told,
                 const BallName& name) {
  const BallSteps& steps = told.steps;
  Json json = steps_json(steps, name);
  json["saturation"] = saturation_json(told.saturation);
  json["request"] = {{"solvent_radius_angstrom", options.request.solvent_radius_angstrom},
                     {"lattice_unit_angstrom", steps.lattice.unit_angstrom()}};
  if (steps.engine == StepsEngine::tuples) {
    json["request"]["edge_optimisation"] = steps.options.edge_optimisation;
    json["request"]["alpha_optimisation"] = steps.options.alpha_optimisation;
  }
  json["input"] = input_json(input, steps.lattice);
  json["program"] = program_json();
  return json;
}

ExitCode run_steps(const StepsOptions& options) {
  const RunContext& context = run_context();
  require_readable({options.input.file});
  Outputs outputs(files_read(options.input));
  JsonResults json(outputs.add("--json", options.json, Outputs::kJson), "");
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  const Input input = open_one_model(options.input, "steps takes one model.", context);
  const Inputs inputs = derived_inputs(input, options.request.solvent_radius_angstrom,
                                       options.request.alpha_angstrom2);
  const StepsRequest asked{
      ball_of(input, *inputs.atoms, options.ball),
      options.engine == "tuples" ? StepsEngine::tuples : StepsEngine::dual_edges,
      options.request.tuples};
  std::shared_ptr<const ExplainedSteps> told;
  WorkThreads threads(1);
  const double milliseconds = timed([&] {
    threads.run([&] { told = make_evaluator().evaluate(explained_steps(asked), inputs, context); });
  });
  clear_progress();
  if (shown) {
    std::cout << input_text(input);
    print_steps(*told);
    const std::string note = rounding_note(options.request, inputs.balls->lattice);
    if (!note.empty()) print_line(std::cout, {"Note", note});
    if (times_shown()) {
      print_line(std::cout, {"Time", milliseconds_text(milliseconds)});
    }
    std::cout << std::flush;
  }
  const BallName name = [&](BallIndex ball) { return atom_text(*inputs.atoms, ball); };
  if (json.wanted()) json.add(result_json(input, options, *told, name));
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

OptionCommand table_of_steps(StepsOptions& options) {
  OptionCommand command{
      "steps", "Show step by step how an engine finds the simplices of one ball", {}};
  command.options = {
      one_file(options.input),
      required(text_option({"--ball", "ATOM",
                            "The ball: an address such as \"A:HIS 87:NE2\", or its number, counted "
                            "from 0 in the order of the atoms used"},
                           options.ball)),
      alpha(options.request),
      number_option({"--solvent", "S", "Solvent radius in Å, added to every radius"},
                    options.request.solvent_radius_angstrom, kSolventRange),
      choice_option({"--engine", "tuples|dual_edges",
                     "Algorithm of the thesis (tuples), or of the dual-edge engine"},
                    options.engine),
      output("--json", "The steps as JSON; - for standard output", options.json)};
  append(command.options, tuple_work(options.request.tuples));
  append(command.options, input(options.input));
  command.check = [&options] {
    if (options.engine != "tuples" && options.request.tuples != TupleOptions{}) {
      throw std::invalid_argument("the options of the tuple engine need --engine tuples");
    }
  };
  return command;
}

}  // namespace

Command steps_command() {
  return make_command<StepsOptions>(
      table_of_steps, run_steps,
      {"alphascope-cli steps 1crn.pdb --ball \"A:CYS 16:SG\" --alpha 1.4"});
}

}  // namespace alphascope::cli
