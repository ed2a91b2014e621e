// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the frames of a recording, one after another, in the current OpenGL context.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/document/picture/recording.hpp"
#include "ui/scene/picture/frame_sink.hpp"
#include "ui/scene/picture/picture.hpp"

namespace alphascope {

// Facts about a written frame.
struct FrameReport {
  int number = 0, of = 0;      // number counts from 1
  double alpha_angstrom2 = 0;  // of a sweep
  double degrees = 0;          // of a turntable
  // Milliseconds for computing and filling arrays (0 if the complex has not changed), for drawing,
  // and for packing and writing.
  double make_milliseconds = 0, draw_milliseconds = 0, write_milliseconds = 0;
};

struct FrameSource {
  // Makes the picture for this alpha (Å²). A turntable calls it once, without alpha. Throws
  // whatever an engine throws.
  std::function<Picture(std::optional<double> alpha, const RunContext& context)> picture;
  std::function<void(const FrameReport& news)> on_frame = {};  // may be empty
};

// Draws all frames and adds them to `sink`, without commit(). The camera stays in place in a sweep,
// and keeps its distance on a turntable. Returns sentences on what the pictures lack; empty:
// nothing. Reports each frame with the time left. Throws whatever drawing, computing and writing
// throw, and Cancelled.
std::string record_frames(Scene& scene, const Recording& recording, const FrameSource& source,
                          FrameSink& sink, const RunContext& context);

// The same without a window: makes an OpenGL context on this thread.
std::string record_frames(const Recording& recording, const FrameSource& source, FrameSink& sink,
                          const RunContext& context);

// The view of a molecule that was turned about an axis through the focal point. The camera goes
// round the other way.
Viewpoint turned_view(const Viewpoint& view, TurnAxis axis, double degrees);

}  // namespace alphascope
