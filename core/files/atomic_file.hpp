// Writing a file so that its name never shows half of it, and never in the place of what was read.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/files/files_read.hpp"
#include "core/text/printable.hpp"

namespace alphascope {

// what() is the complete sentence, naming the path, printable.
struct WriteError : std::runtime_error {
  explicit WriteError(std::string_view sentence) : std::runtime_error(printable(sentence)) {}
};

// An output that would replace a file that was read. Nothing is wrong with disk or folder.
struct ReplacesInput : WriteError {
  using WriteError::WriteError;
};
// Throws ReplacesInput when the file was read (files_read.hpp); `what` begins the sentence and
// names the output: "--csv out.csv".
void refuse_to_replace_input(const std::string& what, const std::filesystem::path& output,
                             FileKind kind = FileKind::other);

// Text goes to a temporary file in the same folder that commit() renames; without commit() nothing
// is left behind and an older file of that name stays. A link is followed, also to a file that is
// not there yet. A file that is replaced keeps its mode, and its owner and group where the system
// allows it. Something that is there and no ordinary file (/dev/null, a pipe), or has no name in
// any folder (memory), is written directly.
class AtomicFile {
 public:
  // All throw WriteError; this and commit() also ReplacesInput. Whatever name, folder and file do
  // not allow shows here.
  explicit AtomicFile(const std::filesystem::path& path, FileKind kind = FileKind::other);
  // Writes directly to a copy of an open descriptor; `name` is for messages.
  AtomicFile(int descriptor, const std::string& name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  // Once the file is whole on the disk.
  void commit();

  // The file that commit() makes or replaces, behind all links; "" when written directly.
  const std::filesystem::path& replaced() const { return target_; }
  // For another program that writes it in place of write(); -1 when written directly.
  int descriptor_of_temporary() const { return temporary_.empty() ? -1 : descriptor_; }

 private:
  friend void commit_together(std::span<AtomicFile* const> files);
  enum class Taken : unsigned char { no, alone, from_nobody, exchanged, set_aside };

  void open_temporary();
  void keep_owner_and_mode() const;
  void make_whole();
  void take_name(bool alone);
  bool set_aside();
  void give_name_back() noexcept;
  void finish() noexcept;
  [[noreturn]] void fail(const char* action) const;

  std::string name_;  // for messages
  FileKind kind_ = FileKind::other;
  std::filesystem::path target_, temporary_;
  std::filesystem::path old_;  // another name of what was there, while others take theirs
  int descriptor_ = -1;
  int slot_ = -1;  // where remove_temporary_files() finds temporary_
  Taken taken_ = Taken::no;
};

// All of them get their names, once each is whole, or none does. Throws as commit() does.
void commit_together(std::span<AtomicFile* const> files);

// Removes the temporary files of all AtomicFiles of the process. Calls only what is allowed in a
// signal handler.
void remove_temporary_files() noexcept;
// For a signal handler that ends the program: no file is made or gets a name any more, programs
// that write to temporary files are killed, and these are removed.
void end_all_writing() noexcept;

// Makes the folder and those above it, and checks that files can be made in it. Throws WriteError.
void make_output_folder(const std::filesystem::path& folder);

// A sentence where no AtomicFile can be made of this path, as far as that is known without making
// one; empty where it seems so that one can.
std::string why_not_writable(const std::filesystem::path& path);

}  // namespace alphascope
