// Loading a whole text file, packed with gzip or not, with every ordinary mishap named.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct LoadedText {
  std::string text;  // unpacked; a UTF-8 byte order mark is removed, CR-only lines get LF
  std::uint64_t file_bytes = 0;
  bool compressed = false;       // told by content, not by name
  bool byte_order_mark = false;  // was there
  std::string sha256;            // when it is known already; see file_hash()
};

// Throws ReadError for a missing file, a directory, a pipe or device (which could block for ever),
// a file without permission, damaged gzip data, or more than max_bytes of text.
LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context);

// SHA-256 of the file's bytes, from what was loaded.
std::string file_hash(const LoadedText& loaded);

}  // namespace alphascope
