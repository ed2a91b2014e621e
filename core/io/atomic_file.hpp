// Writing a file so that its name never shows half of it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/molecule/printable.hpp"

namespace alphascope {

// what() is the complete sentence, naming the path, printable.
struct WriteError : std::runtime_error {
  explicit WriteError(std::string_view sentence) : std::runtime_error(printable(sentence)) {}
};

// Text goes to a temporary file in the same folder that commit() renames; without commit() nothing
// is left behind and an older file of that name stays. A link is followed, also to a file that is
// not there yet. A file that is replaced keeps its mode, and its owner and group where the system
// allows it. Something that is there and no ordinary file (/dev/null, a pipe), or has no name in
// any folder (memory), is written directly.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);  // throws WriteError
  // Writes directly to a copy of an open descriptor; `name` is for messages. Throws WriteError.
  AtomicFile(int descriptor, const std::string& name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);  // throws WriteError
  void commit();                      // throws WriteError

  // The file that commit() makes or replaces, behind all links; "" when written directly.
  const std::filesystem::path& replaced() const { return target_; }
  // The file that lies in its folder until commit(), for another program that writes it in place of
  // write(); "" when written directly.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void open_temporary();
  void keep_owner_and_mode() const;
  [[noreturn]] void fail(const char* action) const;

  std::string name_;  // for messages
  std::filesystem::path target_, temporary_;
  int descriptor_ = -1;
  int slot_ = -1;  // where remove_temporary_files() finds temporary_
};

// Removes the temporary files of all AtomicFiles of the process. For a signal handler that ends the
// program: calls only what is allowed there.
void remove_temporary_files() noexcept;

// Makes the folder and those above it, and checks that files can be made in it. Throws WriteError.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace alphascope
