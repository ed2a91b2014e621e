// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a file, or several beside it, on a thread of its own. All of them appear complete, or
// none.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/jobs/job_list.hpp"
#include "core/files/atomic_file.hpp"
#include "core/run/worker.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

class FileJob : public ViewerJob {
 public:
  struct Task {
    std::filesystem::path file;
    std::string title;        // "Exporting a.vtu"
    std::string error_title;  // "The complex cannot be exported"
    // Runs on the job's thread. Returns a text on the files' content for the status bar; it may be
    // empty.
    std::function<std::string(const RunContext&)> write;
    std::function<void()> when_saved = {};  // runs on the main thread
  };

  FileJob(JobId id, std::function<void()> wake) : id_(id), worker_(std::move(wake)) {}  // as Worker

  // Throws std::runtime_error (a sentence) while another file is being written.
  void start(Task task);
  bool busy() const { return task_.has_value(); }

  std::optional<RunningJob> running() const override;
  // Cancels the job. The files stay as they were, unless the job has already finished.
  void cancel() override { worker_.cancel(); }
  JobNews poll() override;

 private:
  void end(const std::string& text, const Worker::Failure* failure);

  JobId id_;
  std::optional<Task> task_;  // none: nothing is being written
  std::chrono::steady_clock::time_point since_;
  JobNews news_;
  Worker worker_;  // last member, so that its thread is joined first
};

// Creates all files, calls `write` with them on one thread, and commits them together. All other
// threads stay free for the slider. Throws WriteError, Cancelled, and what `write` throws.
void write_together(const std::vector<std::filesystem::path>& names,
                    const std::function<void(const std::vector<AtomicFile*>& files)>& write,
                    const CancelToken& cancel);

}  // namespace alphascope
