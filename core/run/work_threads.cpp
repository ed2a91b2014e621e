// SPDX-License-Identifier: GPL-3.0-or-later
// WorkThreads as a oneTBB arena. oneTBB itself gives it no more threads than the machine has.
#include "core/run/work_threads.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace alphascope {

struct WorkThreads::Arena {
  tbb::task_arena arena;
};

namespace {

// oneTBB counts the CPUs of the main thread when it is first used, and keeps the number. OpenGL by
// Mesa pins that thread to one CPU after the other while it starts. So they are counted before.
[[maybe_unused]] const int cpus_at_start = tbb::info::default_concurrency();

int most_threads() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

// Of the WorkThreads whose work this thread runs; 0: none.
thread_local int threads_of_work = 0;

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
  arena_->arena.execute([&] {
    const int before = std::exchange(threads_of_work, used());
    const auto put_back = [&](int*) { threads_of_work = before; };
    const std::unique_ptr<int, decltype(put_back)> at_end(&threads_of_work, put_back);
    tbb::this_task_arena::isolate([&] { work(); });
  });
}

int WorkThreads::used() const {
  return std::min(count_, most_threads());
}

std::string cpu_text(int threads) {
  return "CPU, " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

int threads_here() {
  if (threads_of_work > 0) return threads_of_work;
  return std::min(tbb::this_task_arena::max_concurrency(), most_threads());
}

std::shared_ptr<WorkThreads> SharedThreads::of(int count) {
  const std::lock_guard lock(mutex_);
  std::weak_ptr<WorkThreads>& known = by_count_[count];
  std::shared_ptr<WorkThreads> threads = known.lock();
  if (!threads) known = threads = std::make_shared<WorkThreads>(count);
  return threads;
}

}  // namespace alphascope
