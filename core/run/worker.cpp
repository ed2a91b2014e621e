// SPDX-License-Identifier: GPL-3.0-or-later
// The worker's thread and the hand-over of results under its lock. No job runs while the lock is
// held.
#include "core/run/worker.hpp"

#include <new>
#include <utility>

namespace alphascope {

namespace {

// The current exception, as a message for the user.
Worker::Failure present_failure() {
  try {
    throw;
  } catch (const Cancelled&) {
    return {.message = "cancelled", .cancelled = true};
  } catch (const std::bad_alloc&) {
    return {.message =
                "there is not enough memory for this computation; close other programs, or choose "
                "a part of the molecule",
            .out_of_memory = true,
            .cause = std::current_exception()};
  } catch (const std::exception& e) {
    return {.message = e.what(), .cause = std::current_exception()};
  } catch (...) {
    return {.message = "an unknown error"};
  }
}

}  // namespace

Worker::Worker(std::function<void()> wake, std::chrono::milliseconds grace)
    : wake_(std::move(wake)), grace_(grace), thread_([this] { run(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    waiting_.reset();
    if (running_) running_->cancel();
  }
  work_.notify_one();
  thread_.join();
}

void Worker::set_grace(std::chrono::milliseconds grace) {
  const std::lock_guard lock(mutex_);
  grace_ = grace;
  cancel_superseded_when_due();
}

void Worker::submit(Job job, FailureHandler on_failure) {
  Request request{std::move(job), std::move(on_failure), {}};
  {
    const std::lock_guard lock(mutex_);
    // The dropped request's captures are destroyed by `request`, after the lock is gone.
    if (waiting_) {
      std::swap(*waiting_, request);
    } else {
      waiting_ = std::move(request);
    }
    cancel_superseded_when_due();
  }
  work_.notify_one();
}

void Worker::when_idle(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    idle_task_.swap(task);
  }
  work_.notify_one();
}

void Worker::cancel() {
  std::optional<Request> dropped;
  const std::lock_guard lock(mutex_);
  dropped.swap(waiting_);
  if (running_) {
    running_->cancel();
    // Only the latest of two unfinished requests gets the message, since the older one was
    // superseded before.
    ending_ = dropped ? Ending::discard : Ending::tell_cancelled;
  }
  if (dropped && dropped->on_failure) {
    arrived_.push_back([tell = std::move(dropped->on_failure)] { tell({"cancelled", true}); });
  }
}

std::size_t Worker::poll() {
  std::size_t count = 0;
  for (;; ++count) {
    Delivery delivery;
    {
      const std::lock_guard lock(mutex_);
      cancel_superseded_when_due();
      if (arrived_.empty()) return count;
      delivery = std::move(arrived_.front());
      arrived_.erase(arrived_.begin());
    }
    delivery();  // may submit again, so not under the lock
  }
}

Worker::Activity Worker::activity() const {
  const std::lock_guard lock(mutex_);
  Activity activity = progress_;
  activity.busy = waiting_ || running_;
  activity.undelivered = !arrived_.empty();
  return activity;
}

void Worker::cancel_superseded_when_due() {
  if (waiting_ && running_ && Clock::now() - started_ >= grace_) running_->cancel();
}

void Worker::run() {
  for (;;) {
    Request request;
    {
      std::unique_lock lock(mutex_);
      work_.wait(lock, [this] { return stop_ || waiting_ || idle_task_; });
      if (stop_) return;
      if (!waiting_) {
        const std::function<void()> task = std::exchange(idle_task_, {});
        lock.unlock();
        task();
        continue;
      }
      request = std::move(*waiting_);
      waiting_.reset();
      running_ = request.cancel;
      started_ = Clock::now();
      progress_ = {};
      ending_ = Ending::deliver;
    }
    run_job(std::move(request));
  }
}

void Worker::run_job(Request request) {
  const RunContext context{request.cancel,
                           [this](std::string_view stage, double share) { report(stage, share); }};
  Delivery delivery;
  std::optional<Failure> failure;
  try {
    delivery = request.job(context);
  } catch (...) {
    failure = present_failure();
  }
  request.job = {};  // its captures may be large, and must be freed before the hand-over
  hand_over(request, delivery, std::move(failure));
  if (wake_) wake_();
}

void Worker::hand_over(Request& request, Delivery& delivery, std::optional<Failure> failure) {
  const std::lock_guard lock(mutex_);
  running_.reset();
  progress_ = {};
  if (stop_ || ending_ == Ending::discard) return;
  if (ending_ == Ending::tell_cancelled) {
    failure = Failure{.message = "cancelled", .cancelled = true, .too_late = !failure};
  } else if (failure && request.cancel.cancelled()) {
    return;  // superseded, so no caller waits for it
  }
  if (!failure) {
    if (!delivery) return;
    arrived_.push_back([deliver = std::move(delivery), tell = std::move(request.on_failure)] {
      try {
        deliver();
      } catch (...) {
        if (!tell) throw;
        tell(present_failure());
      }
    });
  } else if (request.on_failure) {
    arrived_.push_back(
        [tell = std::move(request.on_failure), f = *std::move(failure)] { tell(f); });
  }
}

void Worker::report(std::string_view stage, double share) {
  {
    const std::lock_guard lock(mutex_);
    cancel_superseded_when_due();
    progress_.stage = stage;
    progress_.share = share;
    const Clock::time_point now = Clock::now();
    if (now - last_progress_wake_ < kProgressInterval) return;
    last_progress_wake_ = now;
  }
  if (wake_) wake_();
}

}  // namespace alphascope
