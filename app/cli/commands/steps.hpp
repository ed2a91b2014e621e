// What `steps` is asked, and the command; as commands.hpp.
#pragma once

#include <string>

#include "app/cli/commands.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

struct StepsOptions {
  InputOptions input;
  std::string ball;  // a number from 0, or an address
  std::string engine = "tuples";
  Request request;  // alpha, solvent, the tuple engine's switches
  std::string json;
};

ExitCode run_steps(const StepsOptions& options);
OptionCommand steps_command(StepsOptions& options);

}  // namespace alphascope::cli
