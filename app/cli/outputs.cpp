// SPDX-License-Identifier: GPL-3.0-or-later
// Opens outputs, and compares files by device and inode.
#include "app/cli/outputs.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <stdexcept>

#include "app/cli/failure.hpp"
#include "app/cli/text/terminal.hpp"
#include "core/document/fetch/molecule_id.hpp"
#include "core/files/output_ending.hpp"
#include "core/files/read_error.hpp"
#include "core/files/regular_file.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

bool is_dash(const fs::path& path) {
  return path == "-";
}

bool is_id(const fs::path& path) {
  try {
    return molecule_id_unless_file(path).has_value();
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + ".");
  }
}

// Identifies an ordinary file independently of its names.
struct FileIdentity {
  dev_t device;
  ino_t number;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

std::optional<FileIdentity> identity(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

std::optional<FileIdentity> identity(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? identity(status) : std::nullopt;
}

std::optional<FileIdentity> identity(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? identity(status) : std::nullopt;
}

// Compares folder and name for files that do not exist yet.
bool same_file(const fs::path& a, const fs::path& b) {
  const auto first = identity(a), second = identity(b);
  if (first || second) return first == second;
  std::error_code ignored;
  return !a.empty() && a.filename() == b.filename() &&
         fs::equivalent(fs::absolute(a, ignored).parent_path(),
                        fs::absolute(b, ignored).parent_path(), ignored);
}

}  // namespace

std::vector<fs::path> files_read(const InputOptions& input) {
  return {input.file, input.radii};  // the name of a radii set is noted too, which does no harm
}

std::vector<fs::path> files_read(const std::vector<std::string>& files, const std::string& list,
                                 const InputOptions& input) {
  std::vector<fs::path> read(files.begin(), files.end());
  read.push_back(list);
  read.push_back(input.radii);
  return read;
}

void require_readable(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    if (is_dash(file) || is_id(file)) continue;
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) {
      refuse_opening(file, errno);
    }
    if (S_ISDIR(status.st_mode)) {
      throw ReadError(file, 0, "this is a folder, not a file", "Choose a file inside it");
    }
    if (::access(file.c_str(), R_OK) != 0) {
      refuse_opening(file, errno);
    }
  }
}

Outputs::Outputs(const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs) {
    if (is_dash(input)) {
      note_read(STDIN_FILENO, "standard input");
    } else {
      note_read(input);
    }
  }
  // With ">> FILE", for example, the summary would be appended to the input FILE.
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    if (const auto input = input_replaced_by(descriptor)) {
      throw UsageError(std::string("Standard ") +
                       (descriptor == STDOUT_FILENO ? "output" : "error") + " goes to " + *input +
                       ", which is an input file. Redirect it to another file.");
    }
  }
}

AtomicFile* Outputs::add(const char* option, const std::string& path, Endings endings) {
  if (path.empty()) return nullptr;
  if (is_dash(path)) {
    if (on_standard_output_ != nullptr) {
      throw UsageError(std::string("Only one of ") + on_standard_output_ + " and " + option +
                       " can be -, which is standard output.");
    }
    on_standard_output_ = option;
    outputs_.emplace_back(option);
    summary_to_standard_error();
  } else {
    refuse_clash(option, path);
    const std::string fault = fault_of_ending(path, endings);
    if (!fault.empty()) {
      throw UsageError(std::string(option) + " " + path + ": " + fault + ".");
    }
    outputs_.emplace_back(option, fs::path(path));
    // Links may give one missing file two names.
    for (const Output& other : outputs_) {
      if (&other != &outputs_.back() &&
          same_file(other.file.replaced(), outputs_.back().file.replaced())) {
        throw UsageError(std::string(other.option) + " and " + option + " both name " + path +
                         ". Give each a file of its own.");
      }
    }
  }
  return &outputs_.back().file;
}

void Outputs::refuse_clash(const char* option, const fs::path& path) const {
  const auto output = identity(path);
  if (!output) return;
  const std::string what = std::string(option) + " " + path.string();
  refuse_to_replace_input(what, path);
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    if (output == identity(descriptor)) {
      throw UsageError(what + " is also where standard " +
                       (descriptor == STDOUT_FILENO ? "output" : "error") +
                       " goes. Give the output another name, or - for standard output.");
    }
  }
}

void Outputs::refuse_what_was_read() const {
  for (const Output& output : outputs_) {
    refuse_to_replace_input(std::string(output.option) + " " + output.name, output.file.replaced());
  }
}

void Outputs::commit() {
  std::vector<AtomicFile*> files;
  for (Output& output : outputs_) files.push_back(&output.file);
  commit_together(files);
}

}  // namespace alphascope::cli
