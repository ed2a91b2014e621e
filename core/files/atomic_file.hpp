// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a file so that its name never shows an incomplete file, and never replaces a file that was
// read.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/files/files_read.hpp"
#include "core/text/printable.hpp"

namespace alphascope {

// what() is a complete printable sentence that names the path.
struct WriteError : std::runtime_error {
  explicit WriteError(std::string_view sentence) : std::runtime_error(printable(sentence)) {}
};

// An output would replace a file that was read. Disk and folder are in order.
struct ReplacesInput : WriteError {
  using WriteError::WriteError;
};
// Throws ReplacesInput if `output` is a file that was read (files_read.hpp). `what` begins the
// sentence and names the output: "--csv out.csv".
void refuse_to_replace_input(const std::string& what, const std::filesystem::path& output,
                             FileKind kind = FileKind::other);

// Text goes to a temporary file in the same folder, and commit() renames it. Without commit() no
// file is left behind, and an older file of that name stays. Links are followed, also to a file
// that does not exist yet. A replaced file keeps its mode, and its owner and group if the system
// allows it. A device or pipe (/dev/null), and a file without a name in any folder (memory), is
// written directly.
class AtomicFile {
 public:
  // All members throw WriteError; this constructor and commit() also throw ReplacesInput. Every
  // fault of name, folder or existing file is found here.
  explicit AtomicFile(const std::filesystem::path& path, FileKind kind = FileKind::other);
  // Writes directly to a copy of an open descriptor. `name` is for messages.
  AtomicFile(int descriptor, const std::string& name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view text);
  // Gives the file its name after all of it is on the disk.
  void commit();

  // The file that commit() makes or replaces, with links followed; empty if written directly.
  const std::filesystem::path& replaced() const { return target_; }
  // The descriptor for another program that writes instead of write(); -1 if written directly.
  int descriptor_of_temporary() const { return temporary_.empty() ? -1 : descriptor_; }

 private:
  friend void commit_together(std::span<AtomicFile* const> files);
  enum class Taken : unsigned char { no, alone, from_nobody, exchanged, set_aside };

  void open_temporary();
  void keep_owner_and_mode() const;
  void flush_to_disk();
  void take_name(bool alone);
  bool set_aside();
  void give_name_back() noexcept;
  void finish() noexcept;
  [[noreturn]] void fail(const char* action) const;

  std::string name_;  // for messages
  FileKind kind_ = FileKind::other;
  std::filesystem::path target_, temporary_;
  std::filesystem::path old_;  // second name of the old file while other files take their names
  int descriptor_ = -1;
  int slot_ = -1;  // index in the list of remove_temporary_files()
  Taken taken_ = Taken::no;
};

// Gives all files their names after each is complete, or none of them. Throws as commit() does.
void commit_together(std::span<AtomicFile* const> files);

// Removes the temporary files of all AtomicFiles of the process. Makes only calls that are allowed
// in a signal handler.
void remove_temporary_files() noexcept;
// For a signal handler that ends the program. Afterwards no file is made or renamed. Programs that
// write to temporary files are killed, and these files are removed.
void end_all_writing() noexcept;

// Makes the folder and its parents, and checks that files can be made in it. Throws WriteError.
void make_output_folder(const std::filesystem::path& folder);

// A sentence that says why no AtomicFile can be made of this path, as far as can be known without
// making one. Empty if one seems possible.
std::string why_not_writable(const std::filesystem::path& path);

}  // namespace alphascope
