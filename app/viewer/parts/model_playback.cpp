// SPDX-License-Identifier: GPL-3.0-or-later
// Times of playback, from the time of the last request.
#include "app/viewer/parts/model_playback.hpp"

#include <algorithm>

namespace alphascope {

std::optional<int> ModelPlayback::next(const Scene& scene, double per_second,
                                       Clock::time_point now) {
  if (!last_) last_ = now;  // the model on screen is shown for its full time, too
  if (scene.count < 2 || !scene.settled || seconds_to_next(per_second, now) > 0) {
    return std::nullopt;
  }
  last_ = now;
  const bool at_end = scene.shown < 0 || scene.shown + 1 >= scene.count;
  return at_end ? 0 : scene.shown + 1;
}

double ModelPlayback::seconds_to_next(double per_second, Clock::time_point now) const {
  const double since = last_ ? std::chrono::duration<double>(now - *last_).count() : 0;
  return std::max(0.0, 1 / per_second - since);
}

}  // namespace alphascope
