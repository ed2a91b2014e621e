// SPDX-License-Identifier: GPL-3.0-or-later
// Plays alpha, models (ui/panels/playback.hpp) and the steps of an engine. The next one is
// requested when the last one is on screen, however long that took.
#pragma once

#include <chrono>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/parts/model_playback.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class Playing {
 public:
  static constexpr double kNever = 1e9;  // seconds

  Playing(ViewState& state, const Session& session, const SceneController& scene, DueFrames& due)
      : state_(state), session_(session), scene_(scene), due_(due) {}

  // Call once a frame. `models_settled`: the requested model is on screen, with its complex.
  void step(bool models_settled);
  // Seconds until a model or a step is due; kNever if nothing plays.
  double seconds_to_next() const;
  double seconds_to_next_step() const;

 private:
  using Clock = std::chrono::steady_clock;
  void play_alpha();
  void play_models(bool models_settled);
  void play_steps();

  ViewState& state_;
  const Session& session_;
  const SceneController& scene_;
  DueFrames& due_;
  ModelPlayback models_, steps_;
};

}  // namespace alphascope
