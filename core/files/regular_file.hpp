// SPDX-License-Identifier: GPL-3.0-or-later
// A regular file, open for reading. Pipes and devices are refused, because they could block for
// ever.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/files/files_read.hpp"

namespace alphascope {

// Throws a ReadError that says why the file cannot be opened; `error` is errno.
[[noreturn]] void refuse_opening(const std::filesystem::path& path, int error);

class RegularFile {
 public:
  // Throws ReadError for a missing file, a folder, a pipe or device, and a file without permission.
  // From then on no output of the process replaces the file (files_read.hpp).
  explicit RegularFile(const std::filesystem::path& path, FileKind kind = FileKind::other);
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  int descriptor() const { return descriptor_; }
  std::uint64_t bytes() const { return bytes_; }  // size when it was opened

 private:
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0;
};

}  // namespace alphascope
