// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the running work in words, cancels it, and starts the comparisons with CGAL.
#pragma once

#include <memory>
#include <optional>

#include "app/session/session.hpp"
#include "app/viewer/jobs/activity_job.hpp"
#include "app/viewer/jobs/time_left.hpp"
#include "app/viewer/parts/opening.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class WorkStatus {
 public:
  // Adds the work of session and opening to `jobs`.
  WorkStatus(ViewState& state, Session& session, const SceneController& scene, const Store& store,
             Opening& opening, JobList& jobs);

  // The line on work that nothing waits for. Adds that work to the list of jobs, and the time left
  // of all. Call after JobList::describe().
  void update_background();
  void update_badge();
  void update_cancelled();  // ViewState::computing_cancelled
  // Appends the picture's stages to the timings of the run that made its complex.
  void add_picture_stages();
  void compare();                           // compares the latest answer with CGAL
  void compare_when_due(bool interacting);  // for the setting that compares every answer
  void forget_compared() { compared_ = nullptr; }

 private:
  bool compares_by_itself() const;
  void cancel();  // cancels all work that the picture waits for

  ViewState& state_;
  Session& session_;
  const SceneController& scene_;
  const Store& store_;
  Opening& files_;  // on their way in
  ActivityJob opening_, computing_, comparing_, timing_, reading_;
  TimeLeft time_left_;
  std::shared_ptr<const Answer> compared_;  // the last answer whose comparison was requested
  std::optional<Request> cancelled_;        // the last request whose computation was cancelled
};

}  // namespace alphascope
