// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the transfer, and words its outcome.
#include "app/viewer/jobs/fetcher.hpp"

#include <utility>

#include "ui/panels/failure_kind.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

void Fetcher::start(const MoleculeId& id, const FetchOptions& options, Use use) {
  const unsigned serial = ++serial_;
  request_ = Request{serial, id, std::move(use), {}, std::chrono::steady_clock::now()};
  // An outcome of an earlier request may still be on its way.
  worker_.submit(
      [this, serial, id, options](const RunContext& context) -> Worker::Delivery {
        const std::filesystem::path file = fetch_molecule(id, options, context).file;
        return [this, serial, file] {
          if (is_present(serial)) request_->file = file;
        };
      },
      [this, serial](const Worker::Failure& failure) {
        if (is_present(serial)) fail(failure);
      });
}

void Fetcher::forget() {
  if (!request_) return;
  request_.reset();
  worker_.cancel();
}

void Fetcher::fail(const Worker::Failure& failure) {
  const std::string id = std::exchange(request_, std::nullopt)->id.text();
  if (failure.cancelled) {
    news_.notice = "Fetching " + id + " was cancelled.";
  } else {
    news_.error_title = id + " cannot be fetched";
    news_.error = failure.message;
    news_.error_kind = kind_of(failure.cause, ErrorKind::input);
  }
}

std::optional<RunningJob> Fetcher::running() const {
  if (!request_ || !request_->file.empty()) return std::nullopt;
  RunningJob job = running_job(JobId::fetching, "Fetching " + request_->id.text(),
                               worker_.activity(), request_->since);
  job.step.clear();  // it is as the title
  return job;
}

JobNews Fetcher::poll() {
  worker_.poll();
  if (request_ && !request_->file.empty()) {
    const Request done = *std::exchange(request_, std::nullopt);
    news_.changed = true;
    done.use(done.file);
  }
  return std::exchange(news_, {});
}

}  // namespace alphascope
