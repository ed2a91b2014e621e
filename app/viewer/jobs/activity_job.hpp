// SPDX-License-Identifier: GPL-3.0-or-later
// Lists work that another class owns, such as the session, as a job.
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "app/viewer/jobs/job_list.hpp"
#include "core/run/worker.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

class ActivityJob : public ViewerJob {
 public:
  struct Owner {
    std::function<Worker::Activity()> activity;
    std::function<std::string()> title;  // called while the job runs
    std::function<void()> cancel;
  };
  ActivityJob(JobId id, Owner owner) : id_(id), owner_(std::move(owner)) {}

  std::optional<RunningJob> running() const override {
    const Worker::Activity activity = owner_.activity();
    if (!activity.busy) return std::nullopt;
    return running_job(id_, owner_.title(), activity, since_.value_or(Clock::now()));
  }
  void cancel() override { owner_.cancel(); }
  JobNews poll() override {
    if (!owner_.activity().busy) {
      since_.reset();
    } else if (!since_) {
      since_ = Clock::now();
    }
    return {};  // the owner reports the outcome itself
  }

 private:
  using Clock = std::chrono::steady_clock;
  JobId id_;
  Owner owner_;
  std::optional<Clock::time_point> since_;  // none: it does not run
};

}  // namespace alphascope
