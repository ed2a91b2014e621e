// Exceptions as what a command line says of them: a message and an exit code.
#pragma once

#include <stdexcept>
#include <string>

#include "app/options/exit_code.hpp"
#include "app/options/option_table.hpp"

namespace alphascope::cli {

// A sensible-looking command line that asks for what cannot be.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Failure {
  ExitCode code;
  std::string message;  // sentences
  // Whether another file may go well: not when the user cancelled or an output cannot be written.
  bool of_this_file;
};

// What to do where memory is short, as far as this command has options for it.
void set_memory_remedy(const OptionCommand& command);

// Of the exception being handled: to be called in a catch block.
Failure current_failure();

// "alphascope-cli: MESSAGE" on standard error, after what standard output has waiting.
void print_error(const std::string& message);

}  // namespace alphascope::cli
