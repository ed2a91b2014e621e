// SPDX-License-Identifier: GPL-3.0-or-later
// Loads a whole text file, compressed with gzip or not. Each common fault has its own message.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/files/files_read.hpp"
#include "core/run/cancel_token.hpp"
#include "core/text_files/text_buffer.hpp"
#include "core/text_files/text_limits.hpp"

namespace alphascope {

struct LoadedText {
  TextBuffer buffer;
  // View of the buffer: unpacked, without byte order mark, LF for CR-only line ends.
  std::string_view text;
  std::uint64_t file_bytes = 0;
  bool compressed = false;       // found from the content, not from the name
  bool byte_order_mark = false;  // the file began with one
  std::string sha256;            // empty if not known yet; see file_hash()
};

// Loads a file, or reads a descriptor of any kind to its end; the path is only a name then. Throws
// ReadError for a missing file, a folder, and a file without permission. A pipe or device is
// refused, because it could block for ever. Other errors are damaged gzip data, a line longer than
// kLongestLine, more than max_bytes of text, and gzip data that expand more than any molecule does.
// Only an output of the same kind may replace the file later (files_read.hpp).
LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context, std::optional<int> descriptor = {},
                     FileKind kind = FileKind::other);

// SHA-256 of the bytes of the file, computed from the loaded text.
std::string file_hash(const LoadedText& loaded);

}  // namespace alphascope
