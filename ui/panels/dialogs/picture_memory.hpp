// What is asked of saved pictures and recordings, and what their dialogs remember.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/picture/picture_options.hpp"

namespace alphascope {

struct ScreenshotRequest {
  std::filesystem::path path;
  PictureOptions options;
};

struct RecordRequest {
  std::filesystem::path path;  // as FrameNames takes it, or a movie
  Recording recording;
  PictureOptions options;
  // The open lesson in place of the recording, each step for so long.
  std::optional<double> lesson_seconds = {};
};

struct RecordMemory : RecordChoices {
  bool show = false;
  std::string path;
  std::optional<bool> has_ffmpeg;  // looked for when the dialog opens
};

}  // namespace alphascope
