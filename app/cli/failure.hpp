// SPDX-License-Identifier: GPL-3.0-or-later
// Exceptions as messages and exit codes of the command line.
#pragma once

#include <stdexcept>
#include <string>

#include "app/options/exit_code.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

// Thrown for a command line that can be parsed, but requests something impossible.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Failure {
  ExitCode code;
  std::string message;  // sentences
  // Whether a run over many files goes on with the next one. False after Ctrl-C, if an output
  // cannot be written or would replace an input, and if the engine cannot run here.
  bool of_this_file;
};

// Sets the advice in out-of-memory messages. It names only options that this command has.
void set_memory_remedy(const OptionCommand& command);

// Describes the exception being handled. Call in a catch block.
Failure current_failure();

// Prints "alphascope-cli: MESSAGE" to standard error, after flushing standard output.
void print_error(const std::string& message);

}  // namespace alphascope::cli
