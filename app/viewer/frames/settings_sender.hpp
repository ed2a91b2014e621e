// SPDX-License-Identifier: GPL-3.0-or-later
// Sends changed settings of the panels to session and scene.
#pragma once

#include <chrono>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/frames/move_clock.hpp"
#include "app/viewer/frames/picture_inputs.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class SettingsSender {
 public:
  SettingsSender(ViewState& state, Session& session, SceneController& scene, Store& store,
                 const PictureInputs& inputs, DueFrames& due)
      : state_(state),
        session_(session),
        scene_(scene),
        store_(store),
        inputs_(inputs),
        due_(due) {}

  void begin();  // call once, when the state holds the first settings
  // Call twice a frame: before the panels for changes by commands, after them for changes by
  // panels.
  void send_request();
  // Sends the options that choose the balls. An expression that is not understood is refused.
  void send_selection();
  void send_look(float line_scale);  // `line_scale` as in SceneStyle

  void take_options();  // the session's options become those of the panels

  bool options_are_sent() const { return state_.settings.open == options_; }
  bool all_is_sent() const { return request_is_sent() && options_are_sent(); }
  bool settled() const;  // whether the latest request is answered
  MoveClock& moves() { return moves_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool request_is_sent() const;
  bool awaits_panels() const;

  ViewState& state_;
  Session& session_;
  SceneController& scene_;
  Store& store_;
  const PictureInputs& inputs_;
  DueFrames& due_;
  OpenOptions options_;  // sent last
  Clock::time_point options_sent_at_{};
  MoveClock moves_;
};

}  // namespace alphascope
