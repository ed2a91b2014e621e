// Describes the running work in words, and starts the comparisons with CGAL.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "app/session/session.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class WorkStatus {
 public:
  WorkStatus(ViewState& state, Session& session, const SceneController& scene, const Store& store)
      : state_(state), session_(session), scene_(scene), store_(store) {}

  void update_busy(const Worker::Activity& reading_session);
  void update_badge();
  // Appends the picture's stages to the timings of the run that made its complex.
  void add_picture_stages();
  void compare();                           // compares the latest answer with CGAL
  void compare_when_due(bool interacting);  // for the setting that compares every answer
  void forget_compared() { compared_ = nullptr; }

 private:
  using Clock = std::chrono::steady_clock;
  bool compares_by_itself() const;

  ViewState& state_;
  Session& session_;
  const SceneController& scene_;
  const Store& store_;
  std::shared_ptr<const Answer> compared_;  // the last answer whose comparison was requested
  std::optional<Clock::time_point> busy_since_, comparing_since_;
};

}  // namespace alphascope
