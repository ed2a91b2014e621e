// The work that goes on, in words, and the comparison with CGAL.
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
  // After the engine's stages, in the run that they are of.
  void add_picture_stages();
  void compare();                           // the latest answer with CGAL
  void compare_when_due(bool interacting);  // where each answer is compared by itself
  void forget_compared() { compared_ = nullptr; }

 private:
  using Clock = std::chrono::steady_clock;
  bool compares_by_itself() const;

  ViewState& state_;
  Session& session_;
  const SceneController& scene_;
  const Store& store_;
  std::shared_ptr<const Answer> compared_;  // the last answer for which a comparison was asked
  std::optional<Clock::time_point> busy_since_, comparing_since_;
};

}  // namespace alphascope
