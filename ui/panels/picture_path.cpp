// See the header.
#include "ui/panels/picture_path.hpp"

#include "core/molecule/letter_case.hpp"

namespace alphascope {

std::filesystem::path path_to_save(const std::string& typed, const std::string& ending) {
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(typed, ignored).lexically_normal();
  if (lower_case(path.extension().string()) != ending) path += ending;
  return path;
}

std::filesystem::path picture_path(const std::string& typed) {
  return path_to_save(typed, ".png");
}

std::filesystem::path session_path(const std::string& typed) {
  return path_to_save(typed, ".json");
}

}  // namespace alphascope
