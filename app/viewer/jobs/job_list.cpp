// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the outcomes of all jobs, and lists those that run.
#include "app/viewer/jobs/job_list.hpp"

#include <algorithm>
#include <utility>

#include "ui/panels/dialogs/save_state.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

RunningJob running_job(JobId id, std::string title, const Worker::Activity& activity,
                       std::chrono::steady_clock::time_point since) {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - since;
  return {id, std::move(title), activity.stage, activity.share > 0 ? activity.share : -1,
          seconds.count()};
}

bool JobList::poll() {
  bool frees_memory = false;
  for (ViewerJob* const job : jobs_) {
    const JobNews news = job->poll();
    if (!news.notice.empty()) state_.notice = news.notice;
    if (!news.error.empty()) state_.show_error(news.error_title, news.error, news.error_kind);
    if (!news.saved.empty()) {
      std::error_code ignored;
      const auto whole = std::filesystem::absolute(news.saved, ignored).lexically_normal();
      state_.saving.folder = whole.parent_path();
    }
    const bool any =
        news.changed || news.frees_memory || !news.notice.empty() || !news.error.empty();
    if (any) due_.ask();
    frees_memory |= news.frees_memory;
  }
  describe();
  return frees_memory;
}

void JobList::describe() {
  state_.jobs.clear();
  for (const ViewerJob* const job : jobs_) {
    if (auto running = job->running()) state_.jobs.push_back(*std::move(running));
  }
  std::stable_sort(state_.jobs.begin(), state_.jobs.end(),
                   [](const RunningJob& a, const RunningJob& b) { return a.id < b.id; });
}

void JobList::cancel(JobId id) {
  for (ViewerJob* const job : jobs_) {
    const auto running = job->running();
    if (running && running->id == id) job->cancel();
  }
}

}  // namespace alphascope
