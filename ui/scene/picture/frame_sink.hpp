// Where the frames of a recording go: numbered pictures or a movie.
#pragma once

#include <filesystem>
#include <memory>

#include "core/document/picture/frame_names.hpp"
#include "ui/scene/picture/frame_grab.hpp"

namespace alphascope {

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  // `number` from 1. Throws WriteError and Cancelled.
  virtual void add(int number, const Image& image, const PictureTexts& texts,
                   const RunContext& context) = 0;
  // Behind the last frame; without it there is no movie, and pictures are whole each by itself.
  virtual void commit(const RunContext& context) = 0;
};

struct FrameSinkOptions {
  int width = 0, height = 0;  // pixels
  double frames_per_second = 30;
  bool transparent = false;
  PictureTexts texts;  // of a movie as a whole
  int frames = 1;      // that come at most
};

// By the ending of `path`. That a picture cannot be written, or would replace what is read, shows
// here, whichever it is. Throws std::invalid_argument for a name that does not fit, and what
// AtomicFile and MovieFile throw.
std::unique_ptr<FrameSink> make_frame_sink(const std::filesystem::path& path,
                                           const FrameSinkOptions& options);

}  // namespace alphascope
