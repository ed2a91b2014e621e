// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the ending of a name with those of its format.
#include "core/files/output_ending.hpp"

#include <algorithm>

#include "core/text/letter_case.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_no_ordinary_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return !error && fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

std::string output_ending(const fs::path& path) {
  const std::string ending = lower_case(path.extension().string());
  if (ending.size() < 2 || std::all_of(ending.begin() + 1, ending.end(), is_digit)) return {};
  return ending;
}

std::string fault_of_ending(const fs::path& path, std::span<const std::string_view> endings) {
  const std::string ending = output_ending(path);
  if (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) {
    return {};
  }
  if (is_no_ordinary_file(path)) return {};
  std::string known;
  for (const std::string_view& one : endings) {
    const bool last = &one == &endings.back();
    known += (known.empty() ? "" : last ? " or " : ", ") + std::string(one);
  }
  return "the name must end in " + known + ", not " + printable(ending);
}

}  // namespace alphascope
