// SPDX-License-Identifier: GPL-3.0-or-later
// The files of commands that take many: their names, and a loop that continues after an error.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/input_options.hpp"
#include "app/options/exit_code.hpp"

namespace alphascope::cli {

// The named files, then those of the list. Throws ReadError for an unreadable list, and UsageError
// for impossible names: standard input twice, or none at all.
std::vector<std::string> file_names(const InputFiles& files);

struct FailedFile {
  std::string file, message;
};

struct FilesOutcome {
  std::vector<FailedFile> failed;
  ExitCode code = ExitCode::ok;  // of the first failed file
};

// Calls `use` with each file. A failure among many files is printed to standard error with file and
// reason, and the next file follows. At the end the number of failures is printed. The exception of
// a single file is passed on. Cancelled, WriteError, ReplacesInput and EngineUnavailable are always
// passed on.
FilesOutcome for_each_file(const std::vector<std::string>& files, bool many,
                           const std::function<void(const std::string&)>& use);

}  // namespace alphascope::cli
