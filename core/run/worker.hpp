// A thread that runs one job at a time for a main thread that must never wait; the latest request
// wins. Knows nothing of molecules or engines.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// submit(), cancel() and poll() belong to one thread, the main thread; jobs run on the worker's
// own.
class Worker {
 public:
  // What a finished job leaves to be done on the main thread, inside poll().
  using Delivery = std::function<void()>;
  // Runs on the worker's thread. Throws to report failure; Cancelled when its token says so.
  using Job = std::function<Delivery(const RunContext&)>;

  struct Failure {
    std::string message;
    bool cancelled = false;  // by cancel(), not by a newer request (that is silent)
    bool too_late = false;   // cancelled, but the job had come to its end: its effects are there
    bool out_of_memory = false;
  };
  // Runs on the main thread, inside poll().
  using FailureHandler = std::function<void(const Failure&)>;

  struct Activity {
    bool busy = false;         // a job is waiting or running
    bool undelivered = false;  // poll() has something to do
    std::string stage;
    double share = 0;  // in [0, 1], of the stage

    bool unfinished() const { return busy || undelivered; }
  };

  // `wake` is called from the worker's thread when poll() has something to do or the progress has
  // moved (at most every kProgressInterval); it must be quick and thread-safe, and may be empty.
  // A running job that a newer one supersedes is cancelled once it has run for `grace`: with a
  // grace of zero at once; with more, jobs shorter than it still finish while a slider is dragged
  // (the main thread then has to poll while the worker is busy, as an animation does).
  explicit Worker(std::function<void()> wake = {}, std::chrono::milliseconds grace = {});
  // Cancels what runs, drops what waits, joins. Nothing is delivered any more.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void set_grace(std::chrono::milliseconds grace);

  // Replaces a job that has not started yet, and cancels the running one (see `grace`).
  void submit(Job job, FailureHandler on_failure = {});

  // Has the worker's thread call `task` when no job waits or runs; instead of an earlier one that
  // it has not called. It is no job: it shows no activity, delivers nothing and must not throw.
  void when_idle(std::function<void()> task);

  // Drops the waiting job and cancels the running one; the latest submitted one, if it had not
  // finished, fails with `cancelled`.
  void cancel();

  // Runs what has arrived on the calling thread; returns how many jobs that were. An exception from
  // a delivery goes to its job's failure handler, as the job's own would. Without a handler, or
  // from it, it passes through; the deliveries after it stay for the next poll.
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
