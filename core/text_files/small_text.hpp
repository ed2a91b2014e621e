// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a small text of commands or names at once: a script, a list of files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace alphascope {

struct SmallTextRule {
  const char* what = "";  // "the script"
  std::uint64_t most_bytes = 0;
  const char* remedy = "";  // advice for a text that is too large; without a full stop
};

// The unchanged content of a file or pipe; "-" is standard input. Throws ReadError for a text that
// cannot be read, a folder, and more than rule.most_bytes.
std::string read_small_text(const std::filesystem::path& path, const SmallTextRule& rule);

}  // namespace alphascope
