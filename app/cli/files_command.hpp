// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of commands that take many files: input names, outputs, and the loop over models.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/outputs.hpp"
#include "app/cli/result_files.hpp"

namespace alphascope::cli {

// Paths as given: "-" is standard output, and an empty path is no output.
struct ResultPaths {
  std::string json, csv, out = {};
};

class FilesCommand {
  const InputOptions& input_;
  const OpenOptions open_;

 public:
  // Finds the files and opens the outputs before any computation. `input` must outlive the command.
  // Throws as file_names(), require_readable() and Outputs::add() do.
  FilesCommand(const InputFiles& files, const InputOptions& input, OpenOptions open,
               const ResultPaths& results);

  const bool many, each_model;
  const std::vector<std::string> files;
  Outputs outputs;
  AtomicFile* const out;  // null: not requested
  CsvResults csv;
  JsonResults json;

  // Whether the summary is printed. If a result takes standard output, the summary counts as a
  // note, which --quiet leaves out.
  bool shown() const;

  // Calls `use` with each wanted model of each file, then commits the outputs.
  ExitCode run(const std::function<void(const std::string& file, const Input& input)>& use);
};

}  // namespace alphascope::cli
