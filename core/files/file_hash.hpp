// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of a file on disk (compressed, if it is), of any content and size.
#pragma once

#include <filesystem>
#include <string>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// 64 hexadecimal digits. Throws ReadError for a missing file, a folder, a pipe or device, a file
// without permission, and when reading stops. Throws Cancelled.
std::string hash_of_file(const std::filesystem::path& path, const RunContext& context = {});

}  // namespace alphascope
