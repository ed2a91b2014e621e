// Loading a whole text file, packed with gzip or not, with every ordinary mishap named.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/files/files_read.hpp"
#include "core/files/text_buffer.hpp"
#include "core/files/text_limits.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct LoadedText {
  TextBuffer buffer;
  std::string_view text;  // in the buffer: unpacked, without a UTF-8 mark, CR-only lines with LF
  std::uint64_t file_bytes = 0;
  bool compressed = false;       // told by content, not by name
  bool byte_order_mark = false;  // was there
  std::string sha256;            // when it is known already; see file_hash()
};

// Throws ReadError for a missing file, a directory, a pipe or device (which could block for ever),
// a file without permission, damaged gzip data, a line longer than kLongestLine, more than
// max_bytes of text, or gzip data that unpack to more than any molecule would. With a descriptor,
// that is read to its end, whatever it is, and the path only names it. What was read is never
// replaced, unless by an output of its kind (files_read.hpp).
LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context, std::optional<int> descriptor = {},
                     FileKind kind = FileKind::other);

// SHA-256 of the file's bytes, from what was loaded.
std::string file_hash(const LoadedText& loaded);

}  // namespace alphascope
