// The files that a command writes, or standard output in their place, opened before it computes:
// that one cannot be written should not show only after hours.
#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "app/cli/commands.hpp"
#include "core/io/atomic_file.hpp"

namespace alphascope::cli {

// Every file that `input` reads; "-" is standard input.
std::vector<std::filesystem::path> files_read(const InputOptions& input);
std::vector<std::filesystem::path> files_read(const BenchOptions& options);
// `list`: where some of their names come from; may be empty.
std::vector<std::filesystem::path> files_read(const std::vector<std::string>& files,
                                              const std::string& list, const InputOptions& input);

// Throws ReadError for the first that is missing or may not be read. For commands that take many
// molecules and would otherwise notice only after work on those before it.
void require_readable(const std::vector<std::filesystem::path>& files);

class Outputs {
 public:
  // `inputs`: what no output may replace.
  explicit Outputs(std::vector<std::filesystem::path> inputs) : inputs_(std::move(inputs)) {}

  // Opens what `option` names: null for "", standard output for "-"; the summary then goes to
  // standard error. Throws UsageError for a file that is also an input, another output, or where
  // standard output goes, and for a second "-"; WriteError for what cannot be opened.
  AtomicFile* add(const char* option, const std::string& path);

  // Whether one of them is standard output.
  bool take_standard_output() const { return on_standard_output_ != nullptr; }

  // Throws UsageError for a file that is an input, or where standard output or error goes.
  void refuse_clash(const char* option, const std::filesystem::path& path) const;

  // Gives every file its name. Throws WriteError.
  void commit();

 private:
  struct Output {
    Output(const char* name, const std::filesystem::path& path) : option(name), file(path) {}
    explicit Output(const char* name) : option(name), file(1, "standard output") {}
    const char* option;
    AtomicFile file;
  };
  std::vector<std::filesystem::path> inputs_;
  std::list<Output> outputs_;
  const char* on_standard_output_ = nullptr;  // the option that took it
};

}  // namespace alphascope::cli
