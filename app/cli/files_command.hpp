// What commands that take many files have in common: names, outputs, one model after another.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/outputs.hpp"
#include "app/cli/result_files.hpp"

namespace alphascope::cli {

// As given: "-" is standard output, empty is none.
struct ResultPaths {
  std::string json, csv, out = {};
};

class FilesCommand {
  const InputOptions& input_;
  const OpenOptions open_;

 public:
  // Finds the files and opens the results, before anything is computed. `input` must outlive the
  // command. Throws what file_names(), require_readable() and Outputs::add() throw.
  FilesCommand(const InputFiles& files, const InputOptions& input, OpenOptions open,
               const ResultPaths& results);

  const bool many, each_model;
  const std::vector<std::string> files;
  Outputs outputs;
  AtomicFile* const out;  // null: not asked for
  CsvResults csv;
  JsonResults json;

  // False where quiet: beside a result on standard output the summary is a note.
  bool shown() const;

  // Calls `use` with each model asked for of each file, then gives the outputs their names.
  ExitCode run(const std::function<void(const std::string& file, const Input& input)>& use);
};

}  // namespace alphascope::cli
