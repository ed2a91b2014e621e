// A text of commands or names, read at once: a script, a list of files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace alphascope {

struct SmallTextRule {
  const char* what = "";  // "the script"
  std::uint64_t most_bytes = 0;
  const char* remedy = "";  // where it is larger; without full stop
};

// As it is in the file, or in the pipe of that name; "-" is standard input. Throws ReadError for
// what cannot be read, a folder, and more bytes than there may be.
std::string read_small_text(const std::filesystem::path& path, const SmallTextRule& rule);

}  // namespace alphascope
