// Where a recording goes: numbered pictures, or a movie. By the name alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace alphascope {

enum class RecordingFormat : std::uint8_t { frames, mp4, webm };

// By the ending: .png, .mp4 or .webm. Throws std::invalid_argument, a clause that names them.
RecordingFormat recording_format(const std::filesystem::path& path);

// A name with one place for a number: "frame-%04d.png", "frame-%d.png"; %% stands for %.
class FrameNames {
 public:
  // Throws std::invalid_argument, a clause, when there is no such place, or more than one.
  explicit FrameNames(const std::filesystem::path& pattern);
  // Counted from 1.
  std::filesystem::path name(int number) const;

 private:
  std::filesystem::path folder_;
  std::string before_, after_;
  std::size_t digits_ = 1;  // at least
};

}  // namespace alphascope
