// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that objects are freed on another thread.
#include "core/run/freed_on_other_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace alphascope {
namespace {

// Reports the thread that destroyed it.
struct Told {
  std::shared_ptr<std::atomic<std::thread::id>> by;
  std::shared_ptr<std::atomic<int>> count;
  explicit Told(std::shared_ptr<std::atomic<std::thread::id>> b,
                std::shared_ptr<std::atomic<int>> c)
      : by(std::move(b)), count(std::move(c)) {}
  Told(Told&&) = default;
  ~Told() {
    if (!by) return;  // it was moved from
    *by = std::this_thread::get_id();
    ++*count;
  }
};

TEST(FreedElsewhere, IsFreedOnceByAnotherThread) {
  const auto by = std::make_shared<std::atomic<std::thread::id>>();
  const auto count = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<const Told> held = freed_on_other_thread(Told(by, count));
  const std::weak_ptr<const Told> seen = held;
  std::shared_ptr<const Told> also = held;
  held = nullptr;
  wait_until_freed();
  EXPECT_EQ(*count, 0) << "somebody holds it";
  also = nullptr;
  EXPECT_TRUE(seen.expired());
  wait_until_freed();
  EXPECT_EQ(*count, 1);
  EXPECT_NE(by->load(), std::this_thread::get_id());
}

TEST(FreedElsewhere, MayBeLetGoOfByAnyThread) {
  const auto by = std::make_shared<std::atomic<std::thread::id>>();
  const auto count = std::make_shared<std::atomic<int>>(0);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 250; ++i) freed_on_other_thread(Told(by, count));
      wait_until_freed();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(*count, 1000);
}

}  // namespace
}  // namespace alphascope
