#include "app/cli/many_files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "app/cli/failure.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"

namespace alphascope::cli {
namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";  // UTF-8's

// Names with NUL bytes or line ends inside are names that end with the other of the two.
[[noreturn]] void refuse_other_ends(const std::string& list, char end) {
  if (end == '\n') {
    throw UsageError(list +
                     ": the list has NUL bytes, as find -print0 writes them between names. Add "
                     "--null.");
  }
  throw UsageError(list +
                   ": the list has no NUL byte: its names end with lines. Leave out --null.");
}

void append_names(const std::string& list, std::istream& stream, char end,
                  std::vector<std::string>& names) {
  bool first = true;
  for (std::string name; std::getline(stream, name, end); first = false) {
    if (end == '\n' && name.find('\0') != name.npos) refuse_other_ends(list, end);
    if (end == '\0' && first && stream.eof() && name.ends_with('\n')) {
      refuse_other_ends(list, end);
    }
    if (end == '\n' && first && name.starts_with(kByteOrderMark)) name.erase(0, 3);
    if (end == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) names.push_back(std::move(name));
  }
}

}  // namespace

std::vector<std::string> file_names(const InputFiles& files) {
  std::vector<std::string> names = files.named;
  const char end = files.null_separated ? '\0' : '\n';
  if (files.list == "-") {
    append_names("standard input", std::cin, end, names);
  } else if (!files.list.empty()) {
    errno = 0;
    std::ifstream stream(files.list, std::ios::binary);
    // A folder opens, but nothing can be read from it.
    if (!stream || (stream.peek() == EOF && stream.bad())) {
      throw ReadError(files.list, 0,
                      std::string("the list of files cannot be read") +
                          (errno != 0 ? std::string(": ") + std::strerror(errno) : ""),
                      "Check the name given to --files-from");
    }
    append_names(files.list, stream, end, names);
  }
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
