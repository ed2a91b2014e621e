// SPDX-License-Identifier: GPL-3.0-or-later
// WorkThreads as a oneTBB arena. oneTBB itself gives it no more threads than the machine has.
#include "core/run/work_threads.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace alphascope {

struct WorkThreads::Arena {
  tbb::task_arena arena;
};

namespace {

int most_threads() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace

// For one thread the arena has two places, both for threads of callers. So two callers run at once,
// each on its own thread alone. With one place, a short job would wait for the whole of a long one.
WorkThreads::WorkThreads(int count)
    : arena_(std::make_unique<Arena>()), count_(count > 0 ? count : most_threads()) {
  if (count_ == 1) {
    arena_->arena.initialize(2, 2);
  } else {
    arena_->arena.initialize(count_);
  }
}

WorkThreads::~WorkThreads() = default;

// The work is isolated: a thread that waits for a part of its own work takes no task of another
// caller meanwhile.
void WorkThreads::run(const std::function<void()>& work) {
  arena_->arena.execute([&] { tbb::this_task_arena::isolate([&] { work(); }); });
}

int WorkThreads::used() const {
  return std::min(count_, most_threads());
}

std::string WorkThreads::text() const {
  return "CPU, " + std::to_string(used()) + (used() == 1 ? " thread" : " threads");
}

std::shared_ptr<WorkThreads> SharedThreads::of(int count) {
  const std::lock_guard lock(mutex_);
  std::weak_ptr<WorkThreads>& known = by_count_[count];
  std::shared_ptr<WorkThreads> threads = known.lock();
  if (!threads) known = threads = std::make_shared<WorkThreads>(count);
  return threads;
}

}  // namespace alphascope
