// SPDX-License-Identifier: GPL-3.0-or-later
// Decides when the next model of a molecule, or the next step of an algorithm, is due in playback.
// Knows neither window nor session.
#pragma once

#include <chrono>
#include <optional>

namespace alphascope {

class ModelPlayback {
 public:
  using Clock = std::chrono::steady_clock;

  struct Scene {
    int shown = 0;  // index of the model on screen, or of the requested one; negative: all at once
    int count = 1;  // number of models
    bool settled = false;  // the model is on screen, with its complex
  };

  // Returns the index of the model to show now, or nothing. It waits until the last model is
  // settled, so requests do not pile up. At most `per_second` (above 0) models are given a second.
  // The first model follows the last.
  std::optional<int> next(const Scene& scene, double per_second, Clock::time_point now);

  // Seconds until next() may give a model, if the scene is settled by then.
  double seconds_to_next(double per_second, Clock::time_point now) const;

  void stop() { last_.reset(); }

 private:
  std::optional<Clock::time_point> last_;  // time of the last request, or of the start of playback
};

}  // namespace alphascope
