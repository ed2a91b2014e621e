// Playing the models of a molecule one after the other, or the steps of an algorithm: when the next
// one is due. Knows neither window nor session.
#pragma once

#include <chrono>
#include <optional>

namespace alphascope {

class ModelPlayback {
 public:
  using Clock = std::chrono::steady_clock;

  struct Scene {
    int shown = 0;         // index of the model on screen, or asked for; negative: all at once
    int count = 1;         // models of the molecule
    bool settled = false;  // the model is on screen, with its complex
  };

  // The index of the model to show now, or nothing. Never while the last one is not settled, so
  // that nothing queues up; never more often than `per_second` (above 0). After the last comes the
  // first.
  std::optional<int> next(const Scene& scene, double per_second, Clock::time_point now);

  // Seconds until next() may answer, if the scene is settled by then.
  double seconds_to_next(double per_second, Clock::time_point now) const;

  void stop() { last_.reset(); }

 private:
  std::optional<Clock::time_point> last_;  // when a model was last asked for, or playing began
};

}  // namespace alphascope
