// SPDX-License-Identifier: GPL-3.0-or-later
// Cancels long work from another thread, and reports its progress.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <string_view>

namespace alphascope {

// Thrown by work whose token was cancelled. It is not an error.
struct Cancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

// Copies share one flag. A default-constructed token can be cancelled too.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const { return flag_->load(std::memory_order_relaxed); }
  void throw_if_cancelled() const {
    if (cancelled()) throw Cancelled();
  }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

// The context of a computation, from its caller. `progress` is called on the computing thread with
// the label of the stage and the share that is done, in [0, 1]. It must be quick and may be empty.
struct RunContext {
  CancelToken cancel;
  std::function<void(std::string_view stage, double share)> progress;

  void report(std::string_view stage, double share) const {
    if (progress) progress(stage, share);
  }
};

}  // namespace alphascope
