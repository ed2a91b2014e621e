// The files that a command writes, or standard output in their place, opened before it computes:
// that one cannot be written should not show only after hours.
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

// Every file that `input` reads; "-" is standard input.
std::vector<std::filesystem::path> files_read(const InputOptions& input);
// `list`: where some of their names come from; may be empty.
std::vector<std::filesystem::path> files_read(const std::vector<std::string>& files,
                                              const std::string& list, const InputOptions& input);

// Throws ReadError for the first that is missing or may not be read. For commands that take many
// molecules and would otherwise notice only after work on those before it.
void require_readable(const std::vector<std::filesystem::path>& files);

class Outputs {
 public:
  using Endings = std::initializer_list<std::string_view>;
  static inline const Endings kCsv{".csv", ".txt"}, kJson{".json", ".txt"}, kText{".alpha", ".txt"};

  // `inputs`: what is going to be read, which no output may replace. Throws UsageError where
  // standard output or error goes to one of them.
  explicit Outputs(const std::vector<std::filesystem::path>& inputs);

  // Opens what `option` names: null for "", standard output for "-"; the summary then goes to
  // standard error. Throws UsageError for a file that is also an input, another output, or where
  // standard output goes, for a name with another ending than these, and for a second "-";
  // WriteError for what cannot be opened.
  AtomicFile* add(const char* option, const std::string& path, Endings endings);

  // Whether one of them is standard output.
  bool take_standard_output() const { return on_standard_output_ != nullptr; }

  // Throws UsageError and ReplacesInput for a file that is an input, or where standard output or
  // error goes.
  void refuse_clash(const char* option, const std::filesystem::path& path) const;

  // Throws ReplacesInput when one of them has been read since it was opened, as a session's
  // molecule is.
  void refuse_what_was_read() const;

  // Gives every file its name, or none. Throws WriteError.
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
  const char* on_standard_output_ = nullptr;  // the option that took it
};

}  // namespace alphascope::cli
