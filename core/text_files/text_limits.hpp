// SPDX-License-Identifier: GPL-3.0-or-later
// Limits on the sizes of texts with coordinates, and the messages for texts beyond them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace alphascope {

// Lines of coordinate files are far shorter. A file with a longer line is no text, and is refused
// before its gigabytes are read.
inline constexpr std::size_t kLongestLine = std::size_t{16} << 20;  // bytes

[[noreturn]] void refuse_text_beyond(const std::filesystem::path& path, std::uint64_t limit_bytes);

// Checks line lengths while the text is still growing.
class LineLengths {
 public:
  // `path` is for the message, and must outlive this object.
  explicit LineLengths(const std::filesystem::path& path) : path_(path) {}

  // Checks the text so far. The part that was checked before must not have changed. Throws
  // ReadError.
  void check(std::string_view text);

 private:
  const std::filesystem::path& path_;
  std::size_t seen_ = 0, line_start_ = 0;
};

}  // namespace alphascope
