// See the header.
#include "ui/panels/picture_path.hpp"

#include "core/io/output_ending.hpp"

namespace alphascope {

std::filesystem::path path_to_save(const std::string& typed, const std::string& ending) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(typed, ignored).lexically_normal();
  if (output_ending(path).empty()) path += ending;
  return path;
}

}  // namespace alphascope
