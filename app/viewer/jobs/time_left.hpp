// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates the time left of running jobs from the speed of their present step.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "ui/running_job.hpp"

namespace alphascope {

class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;
  // Call once a frame. Sets RunningJob::seconds_left where it can be told.
  void follow(RunningJobs& jobs, Clock::time_point now = Clock::now());

 private:
  // The beginning of a job's present step, as far as it was seen.
  struct Step {
    JobId id = {};
    std::string title, result;
    double first_share = 0, last_share = 0;
    Clock::time_point since;
    bool is_of(const RunningJob& job) const {
      return id == job.id && title == job.title && result == job.result;
    }
  };
  Step step_of(const RunningJob& job, Clock::time_point now) const;

  std::vector<Step> steps_;
};

}  // namespace alphascope
