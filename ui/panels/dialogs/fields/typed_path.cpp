// SPDX-License-Identifier: GPL-3.0-or-later
// Completes typed paths: home folder, base folder and ending.
#include "ui/panels/dialogs/fields/typed_path.hpp"

#include <cstdlib>

#include "core/files/output_ending.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

namespace fs = std::filesystem;

fs::path typed_path(const std::string& typed, const fs::path& base) {
  std::string text(trimmed(typed));
  if (text.empty()) return {};
  if (text == "~" || text.starts_with("~/")) {
    if (const char* home = std::getenv("HOME")) text = home + text.substr(1);
  }
  const fs::path path(text);
  if (!path.is_relative()) return path.lexically_normal();
  std::error_code ignored;
  return ((base.empty() ? fs::current_path(ignored) : base) / path).lexically_normal();
}

fs::path path_to_save(const std::string& typed, const std::string& ending) {
  fs::path path = typed_path(typed);
  std::error_code ignored;
  const bool has_name = path.has_filename() && !fs::is_directory(path, ignored);
  if (has_name && output_ending(path).empty()) path += ending;
  return path;
}

}  // namespace alphascope
