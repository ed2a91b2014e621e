// SPDX-License-Identifier: GPL-3.0-or-later
// A thread that runs one job at a time for a main thread that must never wait. The latest request
// wins.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct WorkFailure {
  std::string message;
  bool cancelled = false;  // by cancel(); a newer request cancels without a message
  bool too_late = false;   // the job had finished before the cancel, so its effects remain
  bool out_of_memory = false;
  std::exception_ptr cause = {};  // what the job threw; null: it threw nothing
};

// Only the main thread calls submit(), cancel() and poll(). Jobs run on the worker's own thread.
class Worker {
 public:
  // The part of a job that runs on the main thread afterwards, inside poll().
  using Delivery = std::function<void()>;
  // Runs on the worker's thread. An exception is a failure. Throws Cancelled after its token was
  // cancelled.
  using Job = std::function<Delivery(const RunContext&)>;

  using Failure = WorkFailure;
  // Runs on the main thread, inside poll().
  using FailureHandler = std::function<void(const Failure&)>;

  struct Activity {
    bool busy = false;         // a job is waiting or running
    bool undelivered = false;  // poll() has something to do
    std::string stage;
    double share = 0;  // in [0, 1], of the stage

    bool unfinished() const { return busy || undelivered; }
  };

  // `wake` is called from the worker's thread when poll() has something to do, or when the progress
  // has moved (at most every kProgressInterval). It must be quick and thread-safe, and may be
  // empty. A running job that a newer one supersedes is cancelled once it has run for `grace`. A
  // grace of zero cancels at once. A longer grace lets short jobs finish while a slider is dragged.
  // The main thread then has to poll while the worker is busy, as an animation does.
  explicit Worker(std::function<void()> wake = {}, std::chrono::milliseconds grace = {});
  // Cancels the running job, drops the waiting one and joins. Nothing is delivered afterwards.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void set_grace(std::chrono::milliseconds grace);

  // Replaces a job that has not started yet, and cancels the running one (see `grace`).
  void submit(Job job, FailureHandler on_failure = {});

  // Makes the worker's thread call `task` when no job waits or runs. It replaces an earlier task
  // that was not called yet. A task is no job: it shows no activity, delivers nothing and must not
  // throw.
  void when_idle(std::function<void()> task);

  // Drops the waiting job and cancels the running one. The latest submitted job fails with
  // `cancelled` unless it has finished.
  void cancel();

  // Runs the arrived deliveries on the calling thread, and returns their number. An exception of a
  // delivery goes to the failure handler of its job, as one of the job would. If there is no
  // handler, or if the handler throws, the exception leaves poll(). Later deliveries wait for the
  // next poll.
  std::size_t poll();

  Activity activity() const;

  static constexpr std::chrono::milliseconds kProgressInterval{40};

 private:
  using Clock = std::chrono::steady_clock;
  struct Request {
    Job job;
    FailureHandler on_failure;
    CancelToken cancel;
  };

  enum class Ending { deliver, discard, tell_cancelled };

  void run();
  void run_job(Request request);
  void hand_over(Request& request, Delivery& delivery, std::optional<Failure> failure);
  void report(std::string_view stage, double share);
  void cancel_superseded_when_due();  // needs mutex_

  const std::function<void()> wake_;

  mutable std::mutex mutex_;
  std::chrono::milliseconds grace_;
  std::condition_variable work_;
  std::optional<Request> waiting_;
  std::function<void()> idle_task_;
  std::optional<CancelToken> running_;
  Clock::time_point started_;
  Ending ending_ = Ending::deliver;  // of the running job
  bool stop_ = false;
  Activity progress_;
  Clock::time_point last_progress_wake_;
  std::vector<Delivery> arrived_;

  std::thread thread_;  // last: starts when everything above exists
};

}  // namespace alphascope
