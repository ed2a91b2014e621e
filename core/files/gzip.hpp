// Unpacking gzip data in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/files/text_buffer.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// All members of a gzip file, one after another, as gunzip does; zero bytes that pad the file are
// no data. `path` is for messages. Throws ReadError for data that are damaged or end too early, for
// anything else behind the last member (a text that was appended would be lost), a line
// longer than kLongestLine, more than max_bytes, or more than any molecule would unpack to; and
// Cancelled.
TextBuffer unpack_gzip(const std::filesystem::path& path, std::string_view packed,
                       std::uint64_t max_bytes, const RunContext& context);

}  // namespace alphascope
