// SPDX-License-Identifier: GPL-3.0-or-later
// The destination of a recording's frames: numbered pictures or a movie.
#pragma once

#include <filesystem>
#include <memory>

#include "core/document/picture/frame_names.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope {

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  // `number` counts from 1. Throws WriteError and Cancelled.
  virtual void add(int number, const Image& image, const PictureTexts& texts,
                   const RunContext& context) = 0;
  // To be called after the last frame. Without it no movie appears. Pictures are each complete by
  // themselves.
  virtual void commit(const RunContext& context) = 0;
};

struct FrameSinkOptions {
  int width = 0, height = 0;  // pixels
  double frames_per_second = 30;
  bool transparent = false;
  PictureTexts texts;  // for a movie as a whole
  int frames = 1;      // upper bound of the number of frames
  int dpi = 0;         // as for write_png()
};

// Chooses by the ending of `path`. Throws std::invalid_argument for a name that does not fit, and
// whatever AtomicFile and MovieFile throw. For pictures, this tests whether the first and the last
// can be written. It also tests whether any would replace an input file.
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& path,
                                           const FrameSinkOptions& options);

}  // namespace alphascope
