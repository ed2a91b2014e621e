// SHA-256 of a file as it lies on disk, whatever it holds and however large it is.
#pragma once

#include <filesystem>
#include <string>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// 64 hexadecimal digits. Throws ReadError for what load_text() refuses before it reads: no file, a
// folder, a pipe or device, no permission; and when reading stops. Throws Cancelled.
std::string hash_of_file(const std::filesystem::path& path, const RunContext& context = {});

}  // namespace alphascope
