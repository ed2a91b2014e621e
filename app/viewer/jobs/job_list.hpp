// SPDX-License-Identifier: GPL-3.0-or-later
// The list of jobs that run beside the window: each has a title, a share done, a way to cancel it
// and an outcome.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/frames/due_frames.hpp"
#include "core/run/worker.hpp"
#include "ui/panels/error_kind.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

// Events of a job since the last poll().
struct JobNews {
  std::string notice;              // one line on a job that succeeded or was cancelled
  std::string error_title, error;  // why it failed, for a dialog; empty: it did not fail
  ErrorKind error_kind = ErrorKind::computing;
  std::filesystem::path saved;  // a file that was written; empty: none was
  bool changed = false;         // the window has something new to show
  bool frees_memory = false;    // the job has ended, and its memory is free
};

class ViewerJob {
 public:
  virtual ~ViewerJob() = default;
  virtual std::optional<RunningJob> running() const = 0;  // nothing: no job of this kind runs
  virtual void cancel() = 0;                              // no effect if none runs
  virtual JobNews poll() = 0;                             // call once a frame on the main thread
};

// The job that a worker runs, as panels show it. `since`: its start.
RunningJob running_job(JobId id, std::string title, const Worker::Activity& activity,
                       std::chrono::steady_clock::time_point since);

class JobList {
 public:
  JobList(ViewState& state, DueFrames& due) : state_(state), due_(due) {}

  void add(ViewerJob& job) { jobs_.push_back(&job); }  // it must outlive the list
  // Call once a frame. Shows outcomes, and puts the running jobs into ViewState::jobs. Returns
  // whether memory became free.
  bool poll();
  void describe();  // puts the running jobs into ViewState::jobs
  void cancel(JobId id);

 private:
  ViewState& state_;
  DueFrames& due_;
  std::vector<ViewerJob*> jobs_;
};

}  // namespace alphascope
