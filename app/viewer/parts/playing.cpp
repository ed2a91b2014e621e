// SPDX-License-Identifier: GPL-3.0-or-later
// Plays alpha, models and steps: requests the next one when the last one is on screen.
#include "app/viewer/parts/playing.hpp"

#include <algorithm>

#include "core/document/settings/request.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {

void Playing::step(bool models_settled) {
  play_alpha();
  play_models(models_settled);
  play_steps();
}

double Playing::seconds_to_next() const {
  double wait = kNever;
  if (state_.playback.models) {
    wait = models_.seconds_to_next(state_.playback.models_per_second, Clock::now());
  }
  if (state_.steps.playing) wait = std::min(wait, seconds_to_next_step());
  return wait;
}

// Requests the next alpha when the last one is on screen, however long that took.
void Playing::play_alpha() {
  bool& playing = state_.playback.alpha;
  if (!playing || !session_.state().up_to_date() || scene_.busy()) return;
  const NextAlpha next =
      next_alpha(state_.window.alpha_slider, state_.settings.request.alpha_angstrom2,
                 state_.playback.backwards);
  if (next.ended) {
    playing = false;
    return;
  }
  set_alpha(state_.settings.request, next.alpha);
  due_.ask();
}

// Requests a model when the last one is on screen and its time is over.
void Playing::play_models(bool models_settled) {
  if (!state_.playback.models) {
    models_.stop();
    return;
  }
  int& model = state_.settings.open.balls.model;
  const ModelPlayback::Scene scene{model, static_cast<int>(state_.molecule.models.size()),
                                   models_settled && !scene_.busy()};
  if (const auto next = models_.next(scene, state_.playback.models_per_second, Clock::now())) {
    model = *next;
    due_.ask();
  }
}

// Like play_models(), but ends at the last step. No frame is drawn before the next step is due.
void Playing::play_steps() {
  StepsState& memory = state_.steps;
  const bool over = memory.current && memory.at() == memory.last();
  if (over || state_.window.page != kStepsPage) memory.playing = false;
  if (!memory.playing) {
    steps_.stop();
    return;
  }
  const ModelPlayback::Scene scene{static_cast<int>(memory.at()), static_cast<int>(memory.count()),
                                   memory.current && !scene_.busy()};
  if (const auto next = steps_.next(scene, memory.a_second, Clock::now())) {
    memory.show(static_cast<std::size_t>(*next));
    due_.ask();
  }
}

double Playing::seconds_to_next_step() const {
  return steps_.seconds_to_next(state_.steps.a_second, Clock::now());
}

}  // namespace alphascope
