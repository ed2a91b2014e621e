// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks signals during a step, and counts the steps that are in progress.
#include "core/run/uninterrupted_step.hpp"

#include <poll.h>
#include <unistd.h>

#include <atomic>

namespace alphascope {
namespace {

std::atomic<int> steps_under_way{0};
std::atomic<bool> ended{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler reads them");

// All signals but those that an error of this thread raises; these cannot wait.
sigset_t signals_that_can_wait() {
  sigset_t set;
  sigfillset(&set);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) {
    sigdelset(&set, own);
  }
  return set;
}

}  // namespace

UninterruptedStep::UninterruptedStep() {
  const sigset_t waiting = signals_that_can_wait();
  ::pthread_sigmask(SIG_BLOCK, &waiting, &before_);
  steps_under_way.fetch_add(1);
  if (!ended.load()) return;
  steps_under_way.fetch_sub(1);
  for (;;) ::pause();
}

UninterruptedStep::~UninterruptedStep() {
  steps_under_way.fetch_sub(1);
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void end_uninterrupted_steps() noexcept {
  ended.store(true);
  constexpr int kMostMilliseconds = 1000;
  for (int k = 0; k < kMostMilliseconds && steps_under_way.load() > 0; ++k) {
    ::poll(nullptr, 0, 1);
  }
}

}  // namespace alphascope
