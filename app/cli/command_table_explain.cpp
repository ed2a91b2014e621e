// The options of alphascope-cli explain.
#include <algorithm>
#include <stdexcept>

#include "app/cli/option_groups.hpp"
#include "app/options/option_values.hpp"

namespace alphascope::cli {
namespace {

Option optional_alpha(std::optional<Alpha>& alpha) {
  Option option{.names = "--alpha",
                .value = "A",
                .text = "Alpha in Å², to say whether the simplex is in that complex",
                .fallback = "none: every alpha"};
  option.set = [&alpha](const std::string& value) { alpha = alpha_in(value); };
  return option;
}

void require_simplex(const std::vector<int>& simplex) {
  if (simplex.size() > 4) {
    throw std::invalid_argument("--simplex has " + std::to_string(simplex.size()) +
                                " balls: a simplex has 1 to 4");
  }
  for (auto at = simplex.begin(); at != simplex.end(); ++at) {
    if (std::find(simplex.begin(), at, *at) != at) {
      throw std::invalid_argument("--simplex names ball " + std::to_string(*at) +
                                  " twice: give each ball once");
    }
  }
}

}  // namespace

OptionCommand explain_command(ExplainOptions& options) {
  OptionCommand command{
      "explain", "Why a vertex, edge, triangle or tetrahedron is in the complex, or not", {}};
  command.options = {
      one_file(options.input),
      whole_numbers_option({"--simplex", "I,J,K,L",
                            "One to four balls by number, counted from 0 in the order of the atoms "
                            "used, as in the files of compute"},
                           options.simplex, {0, 2'147'483'647}),
      text_option({"--atoms", "ATOMS",
                   "The same by name: addresses such as A:HIS 87:NE2,A:HIS 87:CE1, or an "
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

}  // namespace alphascope::cli
