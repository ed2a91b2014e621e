// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a command on each model of each file, and completes its outputs.
#include "app/cli/files_command.hpp"

#include <utility>

#include "app/cli/text/terminal.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

std::vector<std::string> found(const InputFiles& files) {
  std::vector<std::string> names = file_names(files);
  if (!files.many()) require_readable({names.front()});
  return names;
}

}  // namespace

FilesCommand::FilesCommand(const InputFiles& named, const InputOptions& input, OpenOptions open,
                           const ResultPaths& results)
    : input_(input),
      open_(std::move(open)),
      many(named.many()),
      each_model(cli::each_model(input)),
      files(found(named)),
      outputs(files_read(files, named.list, input)),
      out(outputs.add("--out", results.out, Outputs::kText)),
      csv(outputs.add("--csv", results.csv, Outputs::kCsv)),
      json(outputs.add("--json", results.json, Outputs::kJson), many         ? "results"
                                                                : each_model ? "models"
                                                                             : "") {}

bool FilesCommand::shown() const {
  return verbosity() != Verbosity::quiet || !outputs.take_standard_output();
}

ExitCode FilesCommand::run(
    const std::function<void(const std::string& file, const Input& input)>& use) {
  const FilesOutcome outcome = for_each_file(files, many, [&](const std::string& file) {
    for_each_model(file, input_, open_, run_context(), [&](const Input& model) {
      use(file, model);
      csv.flush();  // so programs that read the table get each model at once
    });
  });
  json.finish(further_json(outcome, many));
  outputs.commit();
  return outcome.code;
}

}  // namespace alphascope::cli
