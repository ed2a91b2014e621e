// SPDX-License-Identifier: GPL-3.0-or-later
// Requests for saved pictures and recordings, and what the dialog for recordings remembers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/picture/picture_options.hpp"

namespace alphascope {

struct ScreenshotRequest {
  std::filesystem::path path;  // empty: the clipboard
  PictureOptions options;
};

struct RecordRequest {
  // Pattern for the names of frames (FrameNames), or the path of a movie.
  std::filesystem::path path;
  Recording recording;
  PictureOptions options;
  // Seconds for each step of the open lesson. If given, the lesson is recorded instead of
  // `recording`.
  std::optional<double> lesson_seconds = {};
};

struct RecordState : RecordSettings {
  bool show = false;
  std::string path;
  std::optional<bool> has_ffmpeg;  // found out when the dialog opens
};

}  // namespace alphascope
