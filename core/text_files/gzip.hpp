// SPDX-License-Identifier: GPL-3.0-or-later
// Unpacks gzip data in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "core/run/cancel_token.hpp"
#include "core/text_files/text_buffer.hpp"

namespace alphascope {

// Unpacks all members of a gzip file, one after another, as gunzip does. Zero bytes of padding are
// ignored. `path` is for messages. Throws ReadError for data that are damaged or end too early.
// Other data behind the last member are an error too, since an appended text would be lost. So are
// a line longer than kLongestLine, more than max_bytes, and data that expand more than any molecule
// does. Throws Cancelled.
TextBuffer unpack_gzip(const std::filesystem::path& path, std::string_view packed,
                       std::uint64_t max_bytes, const RunContext& context);

}  // namespace alphascope
