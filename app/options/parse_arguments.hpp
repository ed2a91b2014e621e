// From arguments to set variables: the only place that knows the parser (CLI11).
#pragma once

#include <string>

#include "app/options/option_table.hpp"

namespace alphascope {

struct ParsedArguments {
  const OptionCommand* command = nullptr;  // of the program's commands; null where it has none
  bool ended = false;                      // the program should print `text` and end
  int exit_code = 0;                       // then; not 0: `text` is an error
  std::string text;                        // ended with a line end
};

// Sets what the arguments say. An error names program, option and reason, and proposes what may
// have been meant.
ParsedArguments parse_arguments(const OptionProgram& program, int argc, const char* const* argv);

}  // namespace alphascope
