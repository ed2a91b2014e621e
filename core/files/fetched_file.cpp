// SPDX-License-Identifier: GPL-3.0-or-later
// Turns addresses into paths and back.
#include "core/files/fetched_file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <system_error>

#include "core/files/user_folder.hpp"

namespace alphascope {

namespace fs = std::filesystem;

fs::path fetched_files_folder() {
  return user_folder("XDG_CACHE_HOME", ".cache");
}

fs::path fetched_file_path(const fs::path& folder, std::string_view address) {
  const std::size_t end = address.find("://");
  return folder / address.substr(0, end) / address.substr(end + 3);
}

std::optional<FetchedFrom> fetched_from(const fs::path& file, const fs::path& in_folder) {
  const fs::path folder = in_folder.lexically_normal();
  std::error_code error;
  const fs::path path = fs::absolute(file, error).lexically_normal();
  if (folder.empty() || error) return std::nullopt;
  auto part = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  if (part.first != folder.end() || part.second == path.end()) return std::nullopt;
  FetchedFrom from;
  from.address = part.second->string() + ":/";
  if (from.address != "https:/" && from.address != "http:/") return std::nullopt;
  while (++part.second != path.end()) from.address += "/" + part.second->string();
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  std::tm utc{};
  char text[32];
  if (::gmtime_r(&status.st_mtim.tv_sec, &utc) == nullptr ||
      std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc) == 0) {
    return std::nullopt;
  }
  from.time = text;
  return from;
}

}  // namespace alphascope
