// The options of alphascope-cli steps.
#include <stdexcept>

#include "app/cli/commands/steps.hpp"
#include "app/cli/option_groups.hpp"
#include "app/options/option_values.hpp"

namespace alphascope::cli {

OptionCommand steps_command(StepsOptions& options) {
  OptionCommand command{
      "steps", "How an engine finds the simplices of one ball, step after step", {}};
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
                     "The thesis' algorithm (tuples), or that of the dual-edge engine"},
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

}  // namespace alphascope::cli
