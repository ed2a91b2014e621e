// SPDX-License-Identifier: GPL-3.0-or-later
// The time limit of a measurement.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "core/run/cancel_token.hpp"

namespace alphascope {

// Cancels its token when the time is over, or when the caller's token is cancelled.
class Deadline {
  using Clock = std::chrono::steady_clock;

 public:
  Deadline(const CancelToken& outer, double seconds)
      : outer_(outer),
        due_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        thread_([this] { watch(); }) {}
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  const CancelToken& token() const { return token_; }

 private:
  void watch() {
    constexpr std::chrono::milliseconds kLook{20};
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kLook, [this] { return over_; })) {
      if (outer_.cancelled() || Clock::now() >= due_) return token_.cancel();
    }
  }

  CancelToken outer_, token_;
  Clock::time_point due_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;  // last
};

// "over 20 s"
inline std::string over_seconds(double seconds) {
  char text[48];
  std::snprintf(text, sizeof text, "over %g s", seconds);
  return text;
}

}  // namespace alphascope
