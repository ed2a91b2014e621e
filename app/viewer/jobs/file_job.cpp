// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the job that writes files, and words its outcome.
#include "app/viewer/jobs/file_job.hpp"

#include <list>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/run/thread_priority.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/failure_kind.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

void FileJob::start(Task task) {
  if (busy()) {
    throw std::runtime_error("Cannot write " + printable(task.file.string()) + ": " +
                             printable(task_->file.string()) +
                             " is still being saved. Wait until it is finished, or cancel it.");
  }
  task_ = std::move(task);
  since_ = std::chrono::steady_clock::now();
  const auto text = std::make_shared<std::string>();  // the job writes it until it has ended
  worker_.submit(
      [this, text, write = task_->write](const RunContext& context) -> Worker::Delivery {
        lower_thread_priority(CpuShare::third);
        *text = write(context);
        return [this, text] { end(*text, nullptr); };
      },
      [this, text](const Worker::Failure& failure) { end(*text, &failure); });
}

void FileJob::end(const std::string& text, const Worker::Failure* failure) {
  const Task task = *std::exchange(task_, std::nullopt);
  const std::string file = printable(task.file.string());
  news_.frees_memory = true;
  if (failure == nullptr || failure->too_late) {
    news_.notice = "Saved " + file + text;
    news_.saved = task.file;
    if (task.when_saved) task.when_saved();
  } else if (failure->cancelled) {
    news_.notice = "Cancelled: " + file + " was not written.";
  } else {
    news_.error_title = task.error_title;
    news_.error = failure->message;
    news_.error_kind = kind_of(failure->cause, ErrorKind::computing);
  }
}

std::optional<RunningJob> FileJob::running() const {
  if (!task_) return std::nullopt;
  return running_job(id_, task_->title, worker_.activity(), since_);
}

JobNews FileJob::poll() {
  worker_.poll();
  return std::exchange(news_, {});
}

void write_together(const std::vector<std::filesystem::path>& names,
                    const std::function<void(const std::vector<AtomicFile*>& files)>& write,
                    const CancelToken& cancel) {
  std::list<AtomicFile> files;
  std::vector<AtomicFile*> open;
  for (const std::filesystem::path& name : names) open.push_back(&files.emplace_back(name));
  WorkThreads threads(1);
  threads.run([&] { write(open); });
  cancel.throw_if_cancelled();
  commit_together(open);
}

}  // namespace alphascope
