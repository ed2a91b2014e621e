// SPDX-License-Identifier: GPL-3.0-or-later
// Parses patterns of file names.
#include "core/document/picture/frame_names.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/letter_case.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

[[noreturn]] void refuse(const std::string& name) {
  throw std::invalid_argument(
      "the name of pictures needs exactly one place for their number, such as frame-%04d.png; " +
      printable(name) + " has " + (name.find('%') == std::string::npos ? "none" : "others"));
}

}  // namespace

RecordingFormat recording_format(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  if (ending == ".png") return RecordingFormat::frames;
  if (ending == ".mp4") return RecordingFormat::mp4;
  if (ending == ".webm") return RecordingFormat::webm;
  throw std::invalid_argument(
      "a recording is written to pictures (frame-%04d.png) or a movie (.mp4, "
      ".webm); " +
      printable(path.filename().string()) + " ends with neither");
}

FrameNames::FrameNames(const std::filesystem::path& pattern) : folder_(pattern.parent_path()) {
  constexpr std::size_t kMostDigits = 9;
  const std::string name = pattern.filename().string();
  bool found = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    std::string& text = found ? after_ : before_;
    if (name[i] != '%') {
      text += name[i];
      continue;
    }
    if (i + 1 < name.size() && name[i + 1] == '%') {
      text += name[++i];
      continue;
    }
    // Accepts "%d", or "%0" and a digit from 1 to 9 before the d.
    const std::size_t end = name.find_first_not_of("0123456789", i + 1);
    if (found || end == std::string::npos || name[end] != 'd') refuse(name);
    const std::string digits = name.substr(i + 1, end - i - 1);
    const bool padded = digits.size() == 2 && digits[0] == '0' && digits[1] != '0';
    if (!digits.empty() && !padded) refuse(name);
    if (padded) digits_ = std::min<std::size_t>(kMostDigits, digits[1] - '0');
    found = true;
    i = end;
  }
  if (!found) refuse(name);
}

std::filesystem::path FrameNames::name(int number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < digits_) digits.insert(0, digits_ - digits.size(), '0');
  return folder_ / (before_ + digits + after_);
}

}  // namespace alphascope
