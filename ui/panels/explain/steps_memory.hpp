// What the page "Steps" remembers between frames. Plain data.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/document/explain/steps_results.hpp"
#include "ui/layer.hpp"

namespace alphascope {

inline constexpr const char* kStepsPage = "steps";  // id of the page

struct StepsMemory {
  static constexpr std::size_t kLast = 1000;  // beyond the last step of every engine

  StepsEngine engine = StepsEngine::tuples;
  // Of the page. The engine that computes the complex has switches of its own.
  bool edge_optimisation = true, alpha_optimisation = true;
  bool marks = true;       // the step is drawn
  std::size_t step = 0;    // that is wanted; beyond the last, the last is shown
  std::string go_to;       // number or name of a step, until the steps are known; empty: none
  bool playing = false;    // the steps follow one another
  double a_second = 0.5;   // steps, while playing
  bool scroll_to = false;  // the present step is to be scrolled into sight
  bool look = false;       // at the ball and its neighbours, as soon as they are known
  double asked_at = 0;     // ImGui's time at which the key that is wanted now was first asked for
  Key asked;               // that key
  // The last answer, grey while it is not that of the present question, and what is drawn of it.
  std::shared_ptr<const ToldSteps> shown;
  std::shared_ptr<const BallSet> balls;
  bool current = false;  // `shown` is that of the present question
  struct Drawn {
    std::size_t step = 0;
    bool light = false;
    Layers layers;  // empty: nothing is drawn yet
  } drawn;
  std::uint64_t layers_made = 0;

  std::size_t count() const { return shown ? shown->steps.steps.size() : 0; }
  std::size_t last() const { return std::max<std::size_t>(count(), 1) - 1; }
  // The step that is shown.
  std::size_t at() const { return count() == 0 ? step : std::min(step, last()); }
  void show(std::size_t wanted) {
    step = wanted;
    scroll_to = true;
    go_to.clear();
  }
};

}  // namespace alphascope
