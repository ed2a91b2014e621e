// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of derived results: balls and complex of the picture on screen. Also wants the results
// of all balls in the background, and reports large objects to the store's budget.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>

#include "app/session/session.hpp"
#include "app/viewer/frames/due_frames.hpp"
#include "app/viewer/parts/shown_marks.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class PictureInputs {
 public:
  PictureInputs(const ViewState& state, const Session& session, const SceneController& scene,
                const ShownMarks& marks, Store& store, DueFrames& due);

  // Call before each frame: takes the picture on screen as the inputs.
  void follow_picture();
  // Call after the panels, so that the store knows their wishes before it starts background work.
  // Wants the whole filtration, so that on the CPU each later alpha is a threshold of it.
  void want_results_for_all_alphas();

  const Inputs& now() const { return inputs_; }  // without balls if there is no picture
  // Whether other balls were taken since the last call.
  bool took_balls() { return std::exchange(took_, false); }

 private:
  using Clock = std::chrono::steady_clock;
  bool may_take(const Answer& shown) const;
  void take(const std::shared_ptr<const Answer>& shown);
  bool computes_on_gpu() const;
  bool needs_filtration() const;
  void note_large_objects();
  void poll_store();

  const ViewState& state_;
  const Session& session_;
  const SceneController& scene_;
  const ShownMarks& marks_;
  Store& store_;
  DueFrames& due_;
  Inputs inputs_;
  bool took_ = false;
  const std::shared_ptr<TriangulationMaker> on_cpu_;
  Clock::time_point taken_at_{};
  std::shared_ptr<const Answer> source_;  // the owner of the balls in inputs_; null: none
  std::uint64_t balls_seen_ = 0, bodies_seen_ = 0, frames_key_ = 0;
  std::shared_ptr<const PreparedBalls> body_;  // the body that bodies_seen_ counted last
};

}  // namespace alphascope
