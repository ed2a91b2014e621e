// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of parallel.hpp, by oneTBB.
#include "core/run/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <functional>

namespace alphascope {
namespace {

using Range = tbb::blocked_range<std::size_t>;

// Each loop has an isolated context. Otherwise, when a task beside the caller throws, oneTBB would
// skip parts of the caller's loops as well, and the caller would not notice.
constexpr auto kOwn = tbb::task_group_context::isolated;

}  // namespace

void run_ranges(std::size_t begin, std::size_t end, std::size_t grain, const void* body,
                CallRange call) {
  if (begin >= end) return;
  tbb::task_group_context own(kOwn);
  tbb::parallel_for(
      Range(begin, end, grain), [=](const Range& range) { call(body, range.begin(), range.end()); },
      own);
}

std::uint64_t sum_ranges(std::size_t begin, std::size_t end, std::size_t grain, const void* body,
                         CallSumRange call) {
  if (begin >= end) return 0;
  tbb::task_group_context own(kOwn);
  return tbb::parallel_reduce(
      Range(begin, end, grain), std::uint64_t{0},
      [=](const Range& range, std::uint64_t before) {
        return before + call(body, range.begin(), range.end());
      },
      std::plus<>(), own);
}

}  // namespace alphascope
