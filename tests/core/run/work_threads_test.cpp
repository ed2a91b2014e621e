// SPDX-License-Identifier: GPL-3.0-or-later
// Tests threads that several callers share.
#include "core/run/work_threads.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

using namespace std::chrono_literals;

TEST(WorkThreads, RunsAndTellsWhatWasThrown) {
  WorkThreads threads(2);
  std::atomic<unsigned> sum{0};
  threads.run([&] { parallel_each(0, 100u, [&](unsigned i) { sum += i; }); });
  EXPECT_EQ(sum, 4950u);
  EXPECT_THROW(threads.run([] { throw std::runtime_error("no"); }), std::runtime_error);
}

constexpr int kMostSaid = 100;  // an exit code has eight bits

[[noreturn]] void say_threads_on_one_cpu() {
  cpu_set_t all, one;
  sched_getaffinity(0, sizeof all, &all);
  CPU_ZERO(&one);
  int cpu = 0;
  while (!CPU_ISSET(cpu, &all)) ++cpu;
  CPU_SET(cpu, &one);
  sched_setaffinity(0, sizeof one, &one);
  std::exit(std::min(WorkThreads().used(), kMostSaid));
}

// The new process of a death test gets the number from this one, as it must not use oneTBB yet.
int threads_of_machine() {
  constexpr const char* kTold = "ALPHASCOPE_TEST_THREADS";
  if (const char* told = std::getenv(kTold)) return std::atoi(told);
  const int threads = WorkThreads().used();
  setenv(kTold, std::to_string(threads).c_str(), 1);
  return threads;
}

// OpenGL pins the main thread for a moment while the window starts. The count is taken before.
TEST(WorkThreadsDeathTest, AreThoseOfTheStart) {
  const int at_start = threads_of_machine();
  if (at_start < 2) GTEST_SKIP() << "one core";
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new process
  EXPECT_EXIT(say_threads_on_one_cpu(), ::testing::ExitedWithCode(std::min(at_start, kMostSaid)),
              "");
}

TEST(WorkThreads, SaysHowManyWork) {
  EXPECT_EQ(WorkThreads(1).text(), "CPU, 1 thread");
  EXPECT_EQ(WorkThreads(1000).asked(), 1000);
  EXPECT_EQ(WorkThreads(1000).used(), WorkThreads().used()) << "as many as the machine has";
}

// Even a single thread has room for a second caller, which works on its own thread.
TEST(WorkThreads, HaveRoomForAsManyAsAreAsked) {
  for (const auto& [asked, room] : {std::pair{1, 2}, {2, 2}, {3, 3}, {7, 7}}) {
    int found = 0;
    WorkThreads(asked).run([&found] { found = tbb::this_task_arena::max_concurrency(); });
    EXPECT_EQ(found, room) << asked;
  }
}

TEST(WorkThreads, TwoCallersHaveNoMoreThreadsThanOne) {
  WorkThreads threads(2);
  std::atomic<int> at_work{0}, most{0};
  const auto work = [&] {
    parallel_each(0, 200u, [&](unsigned) {
      const int now = ++at_work;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(100us);
      --at_work;
    });
  };
  const auto other = std::async(std::launch::async, [&] { threads.run(work); });
  threads.run(work);
  other.wait();
  EXPECT_LE(most, 2);
}

TEST(WorkThreads, SeveralWorkAtOnce) {
  if (WorkThreads().used() < 2) GTEST_SKIP() << "one core";
  WorkThreads threads(2);
  std::atomic<int> at_work{0};
  std::atomic<bool> together{false};
  threads.run([&] {
    parallel_each(0, 2u, [&](unsigned) {
      ++at_work;
      for (int i = 0; i < 20'000 && at_work < 2; ++i) std::this_thread::sleep_for(1ms);
      together = together || at_work == 2;
    });
  });
  EXPECT_TRUE(together);
}

// Two callers share one thread, and the second runs at once. Otherwise a slider would wait for a
// table.
TEST(WorkThreads, OfOneThreadNobodyWaitsForTheOther) {
  WorkThreads threads(1);
  std::atomic<bool> second_ran{false};
  bool ran_meanwhile = false;
  std::promise<void> begun;
  const auto first = std::async(std::launch::async, [&] {
    threads.run([&] {
      begun.set_value();
      for (int i = 0; i < 2000 && !second_ran; ++i) std::this_thread::sleep_for(1ms);
      ran_meanwhile = second_ran;
    });
  });
  begun.get_future().wait();
  threads.run([&] { second_ran = true; });
  first.wait();
  EXPECT_TRUE(ran_meanwhile);
}

TEST(WorkThreads, TheSameForTheSameNumber) {
  SharedThreads shared;
  const auto two = shared.of(2);
  EXPECT_EQ(two, shared.of(2));
  EXPECT_NE(two, shared.of(3));
}

}  // namespace
}  // namespace alphascope
