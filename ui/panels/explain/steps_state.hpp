// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page “Steps” between frames. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/document/store/key.hpp"
#include "core/explain/steps_engine.hpp"
#include "ui/layer.hpp"

namespace alphascope {

struct BallSet;
struct ExplainedSteps;

inline constexpr const char* kStepsPage = "steps";  // id of the page

struct StepsState {
  static constexpr std::size_t kLast = 1000;  // larger than the number of steps of any engine

  StepsEngine engine = StepsEngine::tuples;
  // Switches of the page. The engine that computes the complex has its own.
  bool edge_optimisation = true, alpha_optimisation = true;
  bool marks = true;       // the step is drawn in the view
  std::size_t step = 0;    // the step wanted; if it is beyond the last, the last is shown
  std::string go_to;       // number or name of a step, kept until the steps are known; empty: none
  bool playing = false;    // the steps follow one another
  double a_second = 0.5;   // steps per second while playing
  bool scroll_to = false;  // the list is to be scrolled to the present step
  bool look = false;  // the view is to show the ball and its neighbours, as soon as they are known
  double asked_at = 0;  // when the present key was first asked for, by ImGui's clock
  Key asked;            // the present key
  // The last answer and its drawing. It is grey unless it answers the present question.
  std::shared_ptr<const ExplainedSteps> shown;
  std::shared_ptr<const BallSet> balls;
  bool current = false;  // `shown` answers the present question
  struct Drawn {
    std::size_t step = 0;
    bool light = false;
    Layers layers;  // empty: nothing is drawn yet
  } drawn;
  std::uint64_t layers_made = 0;

  std::size_t count() const;  // of the steps of `shown`
  std::size_t last() const;   // index of the last step; 0 if there are none
  std::size_t at() const;     // index of the step on show
  void show(std::size_t wanted) {
    step = wanted;
    scroll_to = true;
    go_to.clear();
  }
};

}  // namespace alphascope
