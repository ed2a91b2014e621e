// SPDX-License-Identifier: GPL-3.0-or-later
// Tests loops over indices and ranges, on the caller's threads.
#include "core/run/parallel.hpp"

#include <gtest/gtest.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/run/work_threads.hpp"

namespace alphascope {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kCount = 10000;

using Calls = std::vector<std::atomic<int>>;

bool each_once(const Calls& calls, std::size_t begin, std::size_t end) {
  for (std::size_t n = 0; n < calls.size(); ++n) {
    if (calls[n] != (n >= begin && n < end ? 1 : 0)) return false;
  }
  return true;
}

TEST(Parallel, CallsForEachIndexOnce) {
  Calls each(kCount), many(kCount);
  parallel_each(7, kCount - 1, [&](std::size_t n) { ++each[n]; });
  EXPECT_TRUE(each_once(each, 7, kCount - 1));
  parallel_many(kCount, {}, [&](std::size_t n) { ++many[n]; });
  EXPECT_TRUE(each_once(many, 0, kCount));
}

TEST(Parallel, ShortIndicesEndAtTheirLargest) {
  constexpr std::uint32_t kLargest = ~std::uint32_t{0};
  Calls calls(16);
  parallel_each(kLargest - 16, kLargest, [&](std::uint32_t n) { ++calls[n - (kLargest - 16)]; });
  EXPECT_TRUE(each_once(calls, 0, 16));
}

TEST(Parallel, RangesHoldEachIndexOnceAndAreNotShorterThanHalfOfTheGrain) {
  constexpr std::size_t kGrain = kCount / 3;  // larger than a range would be without it
  Calls calls(kCount);
  std::atomic<std::size_t> shortest{kCount};
  parallel_ranges(7, kCount, kGrain, [&](std::size_t first, std::size_t end) {
    for (std::size_t n = first; n != end; ++n) ++calls[n];
    for (std::size_t seen = shortest;
         end - first < seen && !shortest.compare_exchange_weak(seen, end - first);) {
    }
  });
  EXPECT_TRUE(each_once(calls, 7, kCount));
  EXPECT_GE(shortest, kGrain / 2);
}

TEST(Parallel, WhatIsNotLongerThanTheGrainIsOneRange) {
  std::atomic<int> ranges{0};
  parallel_ranges(0, kCount, kCount, [&](std::size_t first, std::size_t end) {
    if (first == 0 && end == kCount) ++ranges;
  });
  EXPECT_EQ(ranges, 1);
}

TEST(Parallel, OfNothingNothingIsCalled) {
  std::atomic<int> calls{0};
  parallel_each(5, std::size_t{5}, [&](std::size_t) { ++calls; });
  parallel_many(0, {}, [&](std::size_t) { ++calls; });
  parallel_ranges(5, std::size_t{5}, 1, [&](std::size_t, std::size_t) { ++calls; });
  const std::uint64_t sum =
      parallel_sum(5, 5, 1, [&](std::size_t, std::size_t) { return std::uint64_t(++calls); });
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(sum, 0u);
}

TEST(Parallel, SumsModulo) {
  const auto sum_of = [](std::size_t first, std::size_t end) {
    std::uint64_t sum = 0;
    for (std::size_t n = first; n != end; ++n) sum += (std::uint64_t{1} << 63) + n;
    return sum;
  };
  EXPECT_EQ(parallel_sum(1, kCount, 64, sum_of), sum_of(1, kCount));
}

TEST(Parallel, WhatABodyThrowsIsThrownToTheCaller) {
  const auto throw_at = [](std::size_t n) {
    if (n == kCount / 2) throw std::runtime_error("no");
  };
  EXPECT_THROW(parallel_each(0, kCount, throw_at), std::runtime_error);
  EXPECT_THROW(parallel_many(kCount, {}, throw_at), std::runtime_error);
  const auto throw_in = [](std::size_t first, std::size_t) -> std::uint64_t {
    throw std::runtime_error(std::to_string(first));
  };
  EXPECT_THROW(parallel_ranges(0, kCount, 64, throw_in), std::runtime_error);
  EXPECT_THROW(parallel_sum(0, kCount, 64, throw_in), std::runtime_error);
}

TEST(Parallel, ManyThrowsWhenItIsCancelled) {
  CancelToken cancel;
  std::atomic<std::size_t> calls{0};
  const auto cancel_all = [&](std::size_t) {
    ++calls;
    cancel.cancel();
  };
  EXPECT_THROW(parallel_many(100 * kCount, cancel, cancel_all), Cancelled);
  EXPECT_LT(calls, 100 * kCount);
}

// An arena of one thread lends no second one.
TEST(Parallel, WorksOnTheCallersThreads) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  const auto note = [&] {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
    return std::uint64_t{0};
  };
  WorkThreads(1).run([&] {
    parallel_each(0, std::size_t{100}, [&](std::size_t) { note(); });
    parallel_ranges(0, std::size_t{100}, 1, [&](std::size_t, std::size_t) { note(); });
    parallel_sum(0, 100, 1, [&](std::size_t, std::size_t) { return note(); });
  });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

// A loop returns when all of it is done, even if a task beside the caller has thrown.
TEST(Parallel, AFailureBesideTheCallerLeavesNothingOut) {
  tbb::task_group group;
  std::atomic<bool> begun{false}, thrown{false}, whole{true};
  group.run([&] {
    begun = true;
    for (int n = 0; n < 2000 && !thrown; ++n) std::this_thread::sleep_for(1ms);
    for (int round = 0; round < 200; ++round) {
      std::atomic<unsigned> done{0};
      parallel_each(0, 100u, [&](unsigned) { ++done; });
      const std::uint64_t sum = parallel_sum(
          0, 100, 1, [](std::size_t a, std::size_t b) { return std::uint64_t{b - a}; });
      if (done != 100 || sum != 100) whole = false;
    }
  });
  for (int n = 0; n < 2000 && !begun; ++n) std::this_thread::sleep_for(1ms);
  group.run([&] {
    thrown = true;
    throw std::runtime_error("no");
  });
  EXPECT_THROW(group.wait(), std::runtime_error);
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace alphascope
