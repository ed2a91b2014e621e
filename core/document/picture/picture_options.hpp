// SPDX-License-Identifier: GPL-3.0-or-later
// Choices for saved pictures and recordings, which sessions keep.
#pragma once

#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/recording.hpp"

namespace alphascope {

struct PictureOptions {
  int width = 1920, height = 1080;  // pixels
  bool transparent = false;
  bool legend = true, scale_bar = false;  // the legend is drawn if colours have a meaning
  CaptionParts caption = {};
  friend bool operator==(const PictureOptions&, const PictureOptions&) = default;
};

struct RecordSettings {
  Recording recording;
  bool of_lesson = false;      // record a lesson instead
  double lesson_seconds = 10;  // duration of each step in a movie
  PictureOptions options{.width = 1280, .height = 720, .caption = usual_caption()};
  friend bool operator==(const RecordSettings&, const RecordSettings&) = default;
};

}  // namespace alphascope
