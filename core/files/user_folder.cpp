// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the user's folders by the environment.
#include "core/files/user_folder.hpp"

#include <cstdlib>

namespace alphascope {

namespace fs = std::filesystem;

fs::path user_folder(const char* variable, const char* below_home) {
  const char* const named = std::getenv(variable);
  // The XDG specification requires that relative paths are ignored.
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "alphascope";
  const char* const home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) {
    return fs::path(home) / below_home / "alphascope";
  }
  return {};
}

}  // namespace alphascope
