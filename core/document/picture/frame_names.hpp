// SPDX-License-Identifier: GPL-3.0-or-later
// The destination of a recording, by its name: numbered pictures or a movie.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace alphascope {

enum class RecordingFormat : std::uint8_t { frames, mp4, webm };

// The format by the ending: .png, .mp4 or .webm. Throws std::invalid_argument with a clause that
// lists them.
RecordingFormat recording_format(const std::filesystem::path& path);

// A file name with one place for a number: "frame-%04d.png", "frame-%d.png"; %% stands for %.
class FrameNames {
 public:
  // Throws std::invalid_argument with a clause unless there is exactly one such place.
  explicit FrameNames(const std::filesystem::path& pattern);
  // `number` counts from 1.
  std::filesystem::path name(int number) const;

 private:
  std::filesystem::path folder_;
  std::string before_, after_;
  std::size_t digits_ = 1;  // least number of digits
};

}  // namespace alphascope
