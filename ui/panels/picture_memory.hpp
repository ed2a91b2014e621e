// What is asked of saved pictures and recordings, and what their dialogs remember.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/document/caption_parts.hpp"
#include "core/document/recording.hpp"

namespace alphascope {

struct PictureOptions {
  int width = 1920, height = 1080;
  bool transparent = false;
  bool legend = true, scale_bar = false;  // legend: where colours mean something
  CaptionParts caption = {};
};

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

struct RecordMemory {
  bool show = false;
  std::string path = "frame-%04d.png";
  Recording recording;
  bool of_lesson = false;  // in place of the recording
  double lesson_seconds = 10;
  PictureOptions options{.width = 1280, .height = 720, .caption = usual_caption()};
  std::optional<bool> has_ffmpeg;  // looked for when the dialog opens
};

}  // namespace alphascope
