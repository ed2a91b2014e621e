// SPDX-License-Identifier: GPL-3.0-or-later
// Draws frames of turntables and sweeps, and measures the time of each.
#include "ui/scene/picture/record_frames.hpp"

#include <chrono>
#include <cmath>

#include "core/geometry/shortest_number.hpp"
#include "ui/scene/picture/step_text.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;
using Vector = std::array<double, 3>;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The upward direction in the picture, at a right angle to the line of sight.
Vector up_in_view(const Viewpoint& view) {
  Vector forward{}, up = view.up;
  double length = 0, along = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    forward[k] = view.focal_point[k] - view.position[k];
    length += forward[k] * forward[k];
    along += forward[k] * up[k];
  }
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    up[k] -= length > 0 ? along / length * forward[k] : 0;
    size += up[k] * up[k];
  }
  for (double& component : up) component /= size > 0 ? std::sqrt(size) : 1;
  return up;
}

Vector axis_of(const Viewpoint& view, TurnAxis axis) {
  switch (axis) {
    case TurnAxis::x:
      return {1, 0, 0};
    case TurnAxis::y:
      return {0, 1, 0};
    case TurnAxis::z:
      return {0, 0, 1};
    case TurnAxis::up:
      break;
  }
  return up_in_view(view);
}

// Reports the next frame and, from the second on, the time left.
void report_frame(const RunContext& context, int frame, int frames, Clock::time_point begun) {
  context.report(step_text("frame", frame, frames, milliseconds_since(begun) / 1000),
                 static_cast<double>(frame) / frames);
}

PictureTexts frame_texts(const Picture& picture, const Recording& recording,
                         const FrameReport& news) {
  PictureTexts texts = picture.texts;
  texts.emplace_back("alphascope:frame",
                     std::to_string(news.number) + " of " + std::to_string(news.of));
  if (recording.kind == RecordingKind::turntable) {
    texts.emplace_back("alphascope:turned_degrees", shortest_number(news.degrees));
  }
  return texts;
}

}  // namespace

Viewpoint turned_view(const Viewpoint& view, TurnAxis axis, double degrees) {
  Viewpoint turned_one = view;
  if (degrees == 0) return turned_one;
  const Vector around = axis_of(view, axis);
  turned_one.position = turned(view.position, view.focal_point, around, -degrees);
  turned_one.up = turned(view.up, {0, 0, 0}, around, -degrees);
  return turned_one;
}

std::string record_frames(Scene& scene, const Recording& recording, const FrameSource& source,
                          FrameSink& sink, const RunContext& context) {
  const bool sweep = recording.kind == RecordingKind::sweep;
  const int frames = frame_count(recording);
  const Clock::time_point begun = Clock::now();
  const RunContext silent{context.cancel, {}};  // for the steps within a frame
  Picture picture;
  MarkedPicture marked;
  std::optional<Viewpoint> start;
  std::string lacks;
  for (int frame = 0; frame < frames; ++frame) {
    context.cancel.throw_if_cancelled();
    report_frame(context, frame, frames, begun);
    FrameReport news{frame + 1, frames};
    Clock::time_point since = Clock::now();
    if (sweep) {
      news.alpha_angstrom2 = alpha_of_frame(recording, frame);
    } else {
      news.degrees = degrees_of_frame(recording, frame);
    }
    if (sweep || frame == 0) {
      picture = source.picture(sweep ? std::optional(news.alpha_angstrom2) : std::nullopt, silent);
      marked = show(scene, picture);
      news.make_milliseconds = milliseconds_since(since);
    }
    if (start) scene.set_viewpoint(turned_view(*start, recording.axis, news.degrees));
    since = Clock::now();
    std::string left_out = picture.not_drawn;
    const Image image = marked_image(scene, marked, left_out, silent);
    if (!start) start = scene.viewpoint();  // the default view is set by the first drawing
    news.draw_milliseconds = milliseconds_since(since);
    since = Clock::now();
    sink.add(news.number, image, frame_texts(picture, recording, news), silent);
    news.write_milliseconds = milliseconds_since(since);
    if (lacks.empty()) lacks = left_out;
    if (source.on_frame) source.on_frame(news);
  }
  return lacks;
}

std::string record_frames(const Recording& recording, const FrameSource& source, FrameSink& sink,
                          const RunContext& context) {
  const EglContext egl;
  Scene scene;
  return record_frames(scene, recording, source, sink, context);
}

}  // namespace alphascope
