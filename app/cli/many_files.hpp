// Commands that take many files: their names, and going on after an error.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"

namespace alphascope::cli {

// Those named and those of the list, in this order. Throws ReadError for a list that cannot be
// read, UsageError for names that cannot be meant: standard input twice, none at all.
std::vector<std::string> file_names(const InputFiles& files);

struct FailedFile {
  std::string file, message;
};

struct FilesOutcome {
  std::vector<FailedFile> failed;
  ExitCode code = ExitCode::ok;  // of the first that failed
};

// Calls `use` with each. Of many, one that fails is named on standard error with the reason, the
// others go on, and in the end their number is printed; of one, the exception is passed on. So is
// what concerns no single file: Cancelled, WriteError, EngineUnavailable.
FilesOutcome for_each_file(const std::vector<std::string>& files, bool many,
                           const std::function<void(const std::string&)>& use);

}  // namespace alphascope::cli
