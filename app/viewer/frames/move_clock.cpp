// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs each picture with the move that asked for it.
#include "app/viewer/frames/move_clock.hpp"

#include <algorithm>

#include "core/document/store/answer.hpp"

namespace alphascope {
namespace {

// A slider that waits for a slow engine asks in each frame. Only the latest requests are answered.
constexpr std::size_t kMost = 256;

}  // namespace

void MoveClock::note_wanted(const Request& request, Clock::time_point now) {
  if (!moves_.empty() && moves_.back().request == request) return;
  if (moves_.size() == kMost) moves_.erase(moves_.begin());
  moves_.push_back({request, now});
}

void MoveClock::follow(const std::shared_ptr<const Answer>& shown,
                       std::optional<Clock::time_point> finished) {
  if (shown != shown_) {
    shown_ = shown;
    drawn_.reset();
    const auto found = std::find_if(moves_.rbegin(), moves_.rend(), [&](const Move& move) {
      return shown && move.request == shown->request;
    });
    if (found == moves_.rend()) {
      milliseconds_.reset();
      return;
    }
    drawn_ = *found;
    moves_.erase(moves_.begin(), found.base());
  }
  if (!drawn_ || !finished) return;
  milliseconds_ = std::chrono::duration<double, std::milli>(*finished - drawn_->at).count();
  drawn_.reset();
}

void MoveClock::forget() {
  moves_.clear();
  drawn_.reset();
  milliseconds_.reset();
}

}  // namespace alphascope
