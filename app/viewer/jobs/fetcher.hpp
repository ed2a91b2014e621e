// SPDX-License-Identifier: GPL-3.0-or-later
// Fetches molecules by their id on a thread of its own. The latest request wins.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/viewer/jobs/job_list.hpp"
#include "core/document/fetch/fetch.hpp"
#include "core/run/worker.hpp"
#include "ui/running_job.hpp"

namespace alphascope {

class Fetcher : public ViewerJob {
 public:
  using Use = std::function<void(const std::filesystem::path& file)>;

  explicit Fetcher(std::function<void()> wake) : worker_(std::move(wake)) {}  // as Worker

  // `use` gets the file, inside poll() on the main thread.
  void start(const MoleculeId& id, const FetchOptions& options, Use use);
  // Drops the request without a word, also when its file has just arrived.
  void forget();
  bool busy() const { return request_.has_value(); }  // until the file is in use

  std::optional<RunningJob> running() const override;
  void cancel() override { worker_.cancel(); }
  JobNews poll() override;

 private:
  struct Request {
    unsigned serial = 0;
    MoleculeId id;
    Use use;
    std::filesystem::path file;  // empty: not fetched yet
    std::chrono::steady_clock::time_point since;
  };
  bool is_present(unsigned serial) const { return request_ && request_->serial == serial; }
  void fail(const Worker::Failure& failure);

  unsigned serial_ = 0;  // of the last request
  std::optional<Request> request_;
  JobNews news_;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope
