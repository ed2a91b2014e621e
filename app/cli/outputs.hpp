// SPDX-License-Identifier: GPL-3.0-or-later
// The output files of a command, or standard output in their place. They are opened before the
// computation, so that an unwritable path fails at once.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/input_options.hpp"
#include "core/files/atomic_file.hpp"

namespace alphascope::cli {

// All files that `input` reads; "-" is standard input.
std::vector<std::filesystem::path> files_read(const InputOptions& input);
// `list`: path of a list with some of the names; may be empty.
std::vector<std::filesystem::path> files_read(const std::vector<std::string>& files,
                                              const std::string& list, const InputOptions& input);

// Throws ReadError for the first file that is missing or unreadable, and UsageError for an invalid
// id. Valid ids are fetched later. Commands on many molecules
// call this first, so that work on other files is not lost.
void require_readable(const std::vector<std::filesystem::path>& files);

class Outputs {
 public:
  using Endings = std::initializer_list<std::string_view>;
  static inline const Endings kCsv{".csv", ".txt"}, kJson{".json", ".txt"}, kText{".alpha", ".txt"};

  // `inputs`: files that will be read, which no output may replace. Throws UsageError if standard
  // output or error goes to one of them.
  explicit Outputs(const std::vector<std::filesystem::path>& inputs);

  // Opens the file that `option` names. "" gives null. "-" gives standard output, and the summary
  // then goes to standard error. Throws UsageError for an input, another output, or the file behind
  // standard output. Throws it also for an ending not in `endings`, and for a second "-". Throws
  // WriteError if the file cannot be opened.
  AtomicFile* add(const char* option, const std::string& path, Endings endings);

  // Whether one output is standard output.
  bool take_standard_output() const { return on_standard_output_ != nullptr; }

  // Throws UsageError or ReplacesInput for an input file, and for the file behind standard output
  // or error.
  void refuse_clash(const char* option, const std::filesystem::path& path) const;

  // Throws ReplacesInput if an output was read after it had been opened, as a session's molecule
  // may be.
  void refuse_what_was_read() const;

  // Renames all files to their final names, or none. Throws WriteError.
  void commit();

 private:
  struct Output {
    Output(const char* of, const std::filesystem::path& path)
        : option(of), name(path.string()), file(path) {}
    explicit Output(const char* of) : option(of), name("-"), file(1, "standard output") {}
    const char* option;
    std::string name;
    AtomicFile file;
  };
  std::list<Output> outputs_;
  const char* on_standard_output_ = nullptr;  // the option that uses it
};

}  // namespace alphascope::cli
