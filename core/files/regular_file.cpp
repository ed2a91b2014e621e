// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a regular file, and refuses folders, pipes and devices with a message.
#include "core/files/regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/files/read_error.hpp"

namespace alphascope {
namespace {

void refuse_what_is_no_file(const std::filesystem::path& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) {
    throw ReadError(path, 0, "this is a folder, not a file", "Choose a file inside it");
  }
  if (!S_ISREG(status.st_mode)) {
    throw ReadError(path, 0, "this is a pipe or a device, not an ordinary file",
                    "Save its content to a file and open that");
  }
}

}  // namespace

void refuse_opening(const std::filesystem::path& path, int error) {
  constexpr const char* kCheckName = "Check the name and the folder";
  struct stat status {};
  if (error == ENOENT && ::lstat(path.c_str(), &status) == 0) {
    throw ReadError(path, 0, "this is a link to a file that does not exist",
                    "Check where it leads, or name the file itself");
  }
  if (error == ENOENT) throw ReadError(path, 0, "there is no such file", kCheckName);
  const bool permission = error == EACCES || error == EPERM;
  throw ReadError(path, 0, std::string("the file cannot be opened: ") + std::strerror(error),
                  permission ? "Check that you may read it, and its folder" : kCheckName);
}

RegularFile::RegularFile(const std::filesystem::path& path, FileKind kind) {
  // The kind is checked before opening, since opening may have an effect on a device. It is checked
  // again afterwards, in case another file has taken the name.
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) refuse_opening(path, errno);
  refuse_what_is_no_file(path, status);
  // O_NONBLOCK: do not wait for a writer, if this is a pipe.
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) refuse_opening(path, errno);
  try {
    if (::fstat(descriptor_, &status) != 0) refuse_opening(path, errno);
    refuse_what_is_no_file(path, status);
    note_read(descriptor_, path, kind);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
  bytes_ = static_cast<std::uint64_t>(status.st_size);
}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace alphascope
