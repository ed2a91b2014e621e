// See the header.
#include "ui/panels/picture_path.hpp"

#include <algorithm>
#include <cctype>

namespace alphascope {

std::filesystem::path path_to_save(const std::string& typed, const std::string& ending) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(typed, ignored).lexically_normal();
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ending) path += ending;
  return path;
}

std::filesystem::path picture_path(const std::string& typed) {
  return path_to_save(typed, ".png");
}

}  // namespace alphascope
