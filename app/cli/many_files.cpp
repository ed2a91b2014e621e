// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lists of names, and runs commands on many files.
#include "app/cli/many_files.hpp"

#include <algorithm>
#include <cstdint>
#include <sstream>

#include "app/cli/failure.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/files/read_error.hpp"
#include "core/text_files/small_text.hpp"

namespace alphascope::cli {
namespace {

// A list of a million names may have 64 MiB, since many names may be long.
constexpr std::uint64_t kLargestList = std::uint64_t{64} << 20;
// The longest name that Linux opens has 4095 bytes.
constexpr std::size_t kMostNames = 1'000'000, kLongestName = 4095;

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

// Refuses a list whose names seem to end with NUL bytes instead of line ends, or the other way
// round.
[[noreturn]] void refuse_other_ends(const std::string& list, char end) {
  if (end == '\n') {
    throw UsageError(list +
                     ": the list has NUL bytes, as find -print0 writes them between names. Add "
                     "--null.");
  }
  throw UsageError(
      list + ": the names in this list end with line ends, not with NUL bytes. Leave out --null.");
}

void append_names(const std::string& file, char end, std::vector<std::string>& names) {
  std::istringstream stream(read_small_text(
      file,
      {"the list of files", kLargestList, "Divide the names into several lists, one name a line"}));
  stream.exceptions(std::ios::badbit);  // otherwise a failed allocation would end the list early
  const std::string list = file == "-" ? "standard input" : file;
  bool first = true;
  std::size_t number = 0;
  for (std::string name; std::getline(stream, name, end); first = false) {
    ++number;
    if (end == '\n' && name.find('\0') != name.npos) refuse_other_ends(list, end);
    if (end == '\0' && first && stream.eof() && name.ends_with('\n')) {
      refuse_other_ends(list, end);
    }
    if (end == '\n' && first && name.starts_with(kByteOrderMark)) name.erase(0, 3);
    if (end == '\n' && name.ends_with('\r')) name.pop_back();
    if (name.size() > kLongestName) {
      throw ReadError(list, number, "this line is longer than any file name can be",
                      "Check that it is a list of files, one a line");
    }
    if (names.size() == kMostNames) {
      throw ReadError(list, number, "there are more than 1,000,000 files", "Make several lists");
    }
    if (!name.empty()) names.push_back(std::move(name));
  }
}

}  // namespace

std::vector<std::string> file_names(const InputFiles& files) {
  std::vector<std::string> names = files.named;
  const char end = files.null_separated ? '\0' : '\n';
  if (!files.list.empty()) append_names(files.list, end, names);
  const auto readers = std::count(names.begin(), names.end(), "-") + (files.list == "-" ? 1 : 0);
  if (readers > 1) throw UsageError("Standard input (-) can be read only once.");
  if (names.empty()) throw UsageError(files.list + ": the list names no files.");
  return names;
}

FilesOutcome for_each_file(const std::vector<std::string>& files, bool many,
                           const std::function<void(const std::string&)>& use) {
  FilesOutcome outcome;
  for (const std::string& file : files) {
    run_context().cancel.throw_if_cancelled();
    try {
      use(file);
    } catch (...) {
      Failure failure = current_failure();
      if (!many || !failure.of_this_file) throw;
      if (failure.message.find(file) == failure.message.npos) {
        failure.message = file + ": " + failure.message;
      }
      print_error(failure.message);
      if (outcome.failed.empty()) outcome.code = failure.code;
      outcome.failed.push_back({file, failure.message});
    }
  }
  if (!outcome.failed.empty()) {
    print_error(grouped(outcome.failed.size()) + " of " + grouped(files.size()) + " files failed.");
  }
  return outcome;
}

}  // namespace alphascope::cli
