// How many threads work in an arena, and saying so.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>

namespace alphascope {

// An arena takes any number, but TBB has no more threads than the machine may run at once.
inline int threads_used(const tbb::task_arena& arena) {
  const auto most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(arena.max_concurrency(), static_cast<int>(most));
}

// "CPU, 2 threads": EngineInfo::device.
inline std::string cpu_text(const tbb::task_arena& arena) {
  const int threads = threads_used(arena);
  return "CPU, " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

}  // namespace alphascope
