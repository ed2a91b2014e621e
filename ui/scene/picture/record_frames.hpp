// Draws the frames of a recording, one after another, in the OpenGL context that is current.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/document/picture/recording.hpp"
#include "ui/scene/picture/frame_sink.hpp"
#include "ui/scene/picture/picture.hpp"

namespace alphascope {

// A frame that is written.
struct FrameNews {
  int number = 0, of = 0;      // from 1
  double alpha_angstrom2 = 0;  // of a sweep
  double degrees = 0;          // of a turntable
  // Of computing and filling arrays (0 where the last complex stays), drawing, packing and writing.
  double make_milliseconds = 0, draw_milliseconds = 0, write_milliseconds = 0;
};

struct FrameSource {
  // What is on the frame of this alpha (Å²); of a turntable, which asks once, without one. Throws
  // what an engine throws.
  std::function<Picture(std::optional<double> alpha, const RunContext& context)> picture;
  std::function<void(const FrameNews& news)> on_frame = {};  // may be empty
};

// All of them see the molecule from the same place or, on a turntable, from as far. Returns what
// pictures lack, in sentences; empty: nothing. Reports frames, with the time that is left; throws
// what drawing, computing and writing throw, and Cancelled. Does not commit.
std::string record_frames(Scene& scene, const Recording& recording, const FrameSource& source,
                          FrameSink& sink, const RunContext& context);

// The same without a window: in an OpenGL context of its own, on this thread.
std::string record_frames(const Recording& recording, const FrameSource& source, FrameSink& sink,
                          const RunContext& context);

// The view after the molecule was turned about the axis through the point looked at: the camera
// goes around it the other way.
Viewpoint turned_view(const Viewpoint& view, TurnAxis axis, double degrees);

}  // namespace alphascope
