// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a small text from a file, a pipe or standard input.
#include "core/text_files/small_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/files/files_read.hpp"
#include "core/files/read_error.hpp"
#include "core/files/regular_file.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = std::size_t{1} << 16;

[[noreturn]] void refuse_size(const fs::path& path, const SmallTextRule& rule) {
  throw ReadError(
      path, 0,
      std::string(rule.what) + " is larger than " + std::to_string(rule.most_bytes >> 20) + " MiB",
      rule.remedy);
}

std::string read_to_end(int descriptor, const fs::path& path, const SmallTextRule& rule) {
  std::string text;
  for (std::size_t size = 0;;) {
    text.resize(size + kChunk);
    const ssize_t got = ::read(descriptor, text.data() + size, kChunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw ReadError(path, 0, std::string(rule.what) + " cannot be read: " + std::strerror(errno),
                      "Check the name");
    }
    size += static_cast<std::size_t>(got);
    if (size > rule.most_bytes) refuse_size(path, rule);
    text.resize(size);
    if (got == 0) return text;
  }
}

// Is this a pipe, as for "<(command)" in a shell, or a terminal?
bool is_stream(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 &&
         (S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode) || S_ISSOCK(status.st_mode));
}

}  // namespace

std::string read_small_text(const fs::path& path, const SmallTextRule& rule) {
  if (path == "-") {
    note_read(STDIN_FILENO, "standard input");
    return read_to_end(STDIN_FILENO, "standard input", rule);
  }
  if (is_stream(path)) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
      throw ReadError(path, 0, std::string(rule.what) + " cannot be read: " + std::strerror(errno),
                      "Check that you may read it");
    }
    try {
      std::string text = read_to_end(descriptor, path, rule);
      ::close(descriptor);
      return text;
    } catch (...) {
      ::close(descriptor);
      throw;
    }
  }
  try {
    const RegularFile file(path);
    if (file.bytes() <= rule.most_bytes) return read_to_end(file.descriptor(), path, rule);
  } catch (const ReadError& error) {
    const std::string what = std::string(rule.what) + " cannot be read";
    if (error.reason().starts_with(rule.what)) throw;
    throw ReadError(path, 0, what + ": " + error.reason(), error.remedy());
  }
  refuse_size(path, rule);
}

}  // namespace alphascope
