// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the running work in words, and starts the comparisons with CGAL.
#pragma once

#include <functional>
#include <memory>

#include "app/session/session.hpp"
#include "app/viewer/jobs/activity_job.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class WorkStatus {
 public:
  // Adds the session's work to `jobs`. `cancel` cancels all work that the picture waits for.
  WorkStatus(ViewState& state, Session& session, const SceneController& scene, const Store& store,
             JobList& jobs, const std::function<void()>& cancel);

  void update_background();  // the line on work that nothing waits for
  void update_badge();
  // Appends the picture's stages to the timings of the run that made its complex.
  void add_picture_stages();
  void compare();                           // compares the latest answer with CGAL
  void compare_when_due(bool interacting);  // for the setting that compares every answer
  void forget_compared() { compared_ = nullptr; }

 private:
  bool compares_by_itself() const;

  ViewState& state_;
  Session& session_;
  const SceneController& scene_;
  const Store& store_;
  ActivityJob opening_, computing_, comparing_;
  std::shared_ptr<const Answer> compared_;  // the last answer whose comparison was requested
};

}  // namespace alphascope
