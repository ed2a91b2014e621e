// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the beginning of each job's step. A share that falls begins another step.
#include "app/viewer/jobs/time_left.hpp"

#include <algorithm>
#include <utility>

namespace alphascope {
namespace {

// Before this time and share the speed of a step is not known well enough.
constexpr double kLeastSeconds = 1, kLeastShare = 0.02;

}  // namespace

TimeLeft::Step TimeLeft::step_of(const RunningJob& job, Clock::time_point now) const {
  const auto known =
      std::find_if(steps_.begin(), steps_.end(), [&](const Step& step) { return step.is_of(job); });
  if (known == steps_.end() || job.share < known->last_share) {
    return {job.id, job.title, job.result, job.share, job.share, now};
  }
  Step step = *known;
  step.last_share = job.share;
  return step;
}

void TimeLeft::follow(RunningJobs& jobs, Clock::time_point now) {
  std::vector<Step> steps;
  for (RunningJob& job : jobs) {
    job.seconds_left = -1;
    if (job.share < 0 || job.waits) continue;
    const Step& step = steps.emplace_back(step_of(job, now));
    const double seconds = std::chrono::duration<double>(now - step.since).count();
    const double done = job.share - step.first_share;
    if (seconds < kLeastSeconds || done < kLeastShare) continue;
    job.seconds_left = seconds * (1 - job.share) / done;
  }
  steps_ = std::move(steps);
}

}  // namespace alphascope
