// SPDX-License-Identifier: GPL-3.0-or-later
// Messages for a text or a line that is too long.
#include "core/text_files/text_limits.hpp"

#include <algorithm>

#include "core/files/read_error.hpp"

namespace alphascope {
namespace {

std::string size_text(std::uint64_t bytes) {
  if (bytes >= 1 << 20) return std::to_string(bytes >> 20) + " MiB";
  if (bytes >= 1 << 10) return std::to_string(bytes >> 10) + " KiB";
  return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
}

// The limit for molecules is larger than this. The limits for sessions, lessons, tables and lists
// are not. So the limit tells which advice fits.
constexpr std::uint64_t kLargestOther = std::uint64_t{64} << 20;

}  // namespace

void refuse_text_beyond(const std::filesystem::path& path, std::uint64_t limit) {
  throw ReadError(path, 0, "the text is larger than the limit of " + size_text(limit),
                  limit <= kLargestOther
                      ? "No file of this kind is so large; check that this is the one that you mean"
                      : "Keep only the atoms that you need, in a file of their own");
}

void LineLengths::check(std::string_view text) {
  const std::string_view fresh = text.substr(seen_);
  const std::size_t last = fresh.find_last_of("\n\r");
  if (last != std::string_view::npos) line_start_ = seen_ + last + 1;
  seen_ = text.size();
  if (seen_ - line_start_ <= kLongestLine) return;
  const std::string_view before = text.substr(0, line_start_);
  throw ReadError(path_,
                  1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
                  "this line is longer than " + size_text(kLongestLine),
                  "No coordinate file has such lines; check that this is one, and fetch it again");
}

}  // namespace alphascope
