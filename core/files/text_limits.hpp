// Limits of what is accepted as a text with coordinates, and the messages when they are passed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace alphascope {

// No line of a coordinate file is nearly so long; what has one is no text, and is refused before
// its gigabytes are read.
inline constexpr std::size_t kLongestLine = std::size_t{16} << 20;  // bytes

[[noreturn]] void refuse_text_beyond(const std::filesystem::path& path, std::uint64_t limit_bytes);

// Refuses a line that is too long while the text still grows.
class LineLengths {
 public:
  // `path` is for the message; it must live as long as this.
  explicit LineLengths(const std::filesystem::path& path) : path_(path) {}

  // The text up to now; what was seen before must not have changed. Throws ReadError.
  void look_at(std::string_view text);

 private:
  const std::filesystem::path& path_;
  std::size_t seen_ = 0, line_start_ = 0;
};

}  // namespace alphascope
