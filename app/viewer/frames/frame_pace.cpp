// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the window's frames.
#include "app/viewer/frames/frame_pace.hpp"

#include <algorithm>

#include "ui/panels/view_state.hpp"

namespace alphascope {
namespace {

// A tooltip appears when the mouse rests, which is no event. So a frame is drawn after this time.
// More frames follow it, since ImGui hides a tooltip in its first frame to measure it.
constexpr std::chrono::milliseconds kTooltipFrameAfter{450};
static_assert(kTooltipFrameAfter.count() > 1000 * kTooltipDelaySeconds);
constexpr double kBusyInterval = 0.05, kIdleInterval = 1.0;  // seconds
constexpr double kMostFrames = 60, kWhileComputing = 25;     // a second

}  // namespace

void FramePace::begin_frame() {
  begun_at_ = Clock::now();
  due_.news = false;
}

void FramePace::note_wait(bool events) {
  if (events) {
    due_.ask();
    tooltip_due_ = Clock::now() + kTooltipFrameAfter;
  } else if (tooltip_due_ && Clock::now() >= *tooltip_due_) {
    due_.ask();
    tooltip_due_.reset();
  }
}

double FramePace::idle_seconds(bool working, double soonest) const {
  if (due_.any()) return 0;
  double wait = std::min(working ? kBusyInterval : kIdleInterval, soonest);
  if (tooltip_due_) {
    wait = std::min(wait, std::chrono::duration<double>(*tooltip_due_ - Clock::now()).count());
  }
  return std::max(0.001, wait);
}

double FramePace::seconds_to_next_frame(bool yields) const {
  if (due_.news) return 0;
  const std::chrono::duration<double> since = Clock::now() - begun_at_;
  return 1 / (yields ? kWhileComputing : kMostFrames) - since.count();
}

}  // namespace alphascope
