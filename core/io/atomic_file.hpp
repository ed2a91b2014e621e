// Writing a file so that its name never shows half of it.
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace alphascope {

// what() is the complete sentence, naming the path.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Text goes to a neighbouring temporary file that commit() renames; without commit() nothing is
// left behind and an older file of that name stays. A link is followed. Something that is there and
// no ordinary file (/dev/null, a pipe) is written to directly.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);  // throws WriteError
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);  // throws WriteError
  void commit();                      // throws WriteError

 private:
  [[noreturn]] void fail(const char* action) const;

  std::filesystem::path path_, temporary_;  // temporary_ is empty when written to directly
  std::FILE* file_ = nullptr;
};

}  // namespace alphascope
