// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when the next frame of the window is due, and owns the count of frames to draw.
#pragma once

#include <chrono>
#include <optional>

#include "app/viewer/frames/due_frames.hpp"

namespace alphascope {

class FramePace {
 public:
  DueFrames& due() { return due_; }
  const DueFrames& due() const { return due_; }

  void begin_frame();
  // Call with each wait for events. Keeps a frame for the tooltip of a mouse that comes to rest.
  void note_wait(bool events);
  // Seconds to wait for events. `working`: jobs run, whose progress is shown. `soonest`: seconds
  // until something else is due.
  double idle_seconds(bool working, double soonest) const;
  // Seconds until the next frame may be drawn. `yields`: fewer frames leave cores to computations.
  double seconds_to_next_frame(bool yields) const;

 private:
  using Clock = std::chrono::steady_clock;

  DueFrames due_;
  Clock::time_point begun_at_{};  // of the last frame
  std::optional<Clock::time_point> tooltip_due_;
};

}  // namespace alphascope
