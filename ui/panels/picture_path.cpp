// See the header.
#include "ui/panels/picture_path.hpp"

namespace alphascope {

std::filesystem::path picture_path(const std::string& typed) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(typed, ignored).lexically_normal();
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".PNG") path += ".png";
  return path;
}

}  // namespace alphascope
