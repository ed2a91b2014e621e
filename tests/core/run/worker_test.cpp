// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the worker's promises. The test holds and releases jobs by hand, so it never sleeps for
// luck.
#include "core/run/worker.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <future>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace alphascope {
namespace {

using std::chrono::milliseconds;

// Blocks jobs until opened, and notices when their token is cancelled.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void wait_open(const RunContext& context) {
    entered_.store(true);
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, milliseconds(1), [this] { return open_; })) {
      context.cancel.throw_if_cancelled();
    }
  }
  void wait_entered() const {
    while (!entered_.load()) std::this_thread::yield();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  std::atomic<bool> entered_{false};
};

void poll_until_idle(Worker& worker) {
  while (worker.activity().busy) {
    worker.poll();
    std::this_thread::yield();
  }
  worker.poll();
}

TEST(Worker, DeliversOnThePollingThread) {
  Worker worker;
  std::thread::id job_thread, delivery_thread;
  worker.submit([&](const RunContext&) -> Worker::Delivery {
    job_thread = std::this_thread::get_id();
    return [&] { delivery_thread = std::this_thread::get_id(); };
  });
  poll_until_idle(worker);
  EXPECT_EQ(delivery_thread, std::this_thread::get_id());
  EXPECT_NE(job_thread, std::this_thread::get_id());
  EXPECT_NE(job_thread, std::thread::id());
}

TEST(Worker, IsUnfinishedUntilItsOutcomeIsDelivered) {
  Worker worker;
  EXPECT_FALSE(worker.activity().unfinished());
  worker.submit([](const RunContext&) -> Worker::Delivery { return [] {}; });
  while (worker.activity().busy) {
    EXPECT_TRUE(worker.activity().unfinished());
    std::this_thread::yield();
  }
  EXPECT_TRUE(worker.activity().unfinished());
  worker.poll();
  EXPECT_FALSE(worker.activity().unfinished());
}

TEST(Worker, CallsATaskOnItsThreadWhenNoJobWaits) {
  Worker worker;
  Gate gate;
  std::vector<std::string> order;
  std::atomic<int> calls{0};
  std::thread::id task_thread;
  worker.submit([&](const RunContext& context) -> Worker::Delivery {
    gate.wait_open(context);
    order.push_back("job");
    return {};
  });
  gate.wait_entered();
  worker.when_idle([&] { order.push_back("replaced"); });
  worker.when_idle([&] {
    order.push_back("task");
    task_thread = std::this_thread::get_id();
    ++calls;
  });
  gate.open();
  while (calls == 0) std::this_thread::yield();
  EXPECT_EQ(order, (std::vector<std::string>{"job", "task"}));
  EXPECT_NE(task_thread, std::this_thread::get_id());
  EXPECT_FALSE(worker.activity().busy);

  worker.when_idle([&] { ++calls; });  // for an idle worker
  while (calls == 1) std::this_thread::yield();
  poll_until_idle(worker);
  EXPECT_EQ(calls, 2);
}

TEST(Worker, DropsTheUnstartedAndCancelsTheRunning) {
  Worker worker;
  Gate gate;
  std::vector<int> delivered;
  bool first_failed = false, second_ran = false;
  worker.submit(
      [&](const RunContext& context) -> Worker::Delivery {
        gate.wait_open(context);  // never opened: only cancelling ends it
        return [&] { delivered.push_back(1); };
      },
      [&](const Worker::Failure&) { first_failed = true; });
  gate.wait_entered();
  worker.submit([&](const RunContext&) -> Worker::Delivery {
    second_ran = true;
    return [&] { delivered.push_back(2); };
  });
  // The first may have ended already. The second may then have run, in order.
  worker.submit(
      [&](const RunContext&) -> Worker::Delivery { return [&] { delivered.push_back(3); }; });
  poll_until_idle(worker);
  ASSERT_FALSE(delivered.empty());
  EXPECT_EQ(delivered.back(), 3);
  EXPECT_EQ(delivered.size(), second_ran ? 2u : 1u);
  EXPECT_FALSE(first_failed) << "being superseded is not a failure";
}

// Longer than the test takes, and shorter than machines have been on. Grace begins with the job,
// not with the clock.
TEST(Worker, GraceLetsShortJobsFinish) {
  Worker worker({}, std::chrono::seconds(60));
  Gate gate;
  std::vector<int> delivered;
  std::atomic<bool> cancelled{false};
  worker.submit([&](const RunContext& context) -> Worker::Delivery {
    gate.wait_open(context);
    cancelled = context.cancel.cancelled();
    return [&] { delivered.push_back(1); };
  });
  gate.wait_entered();
  for (int request = 2; request <= 50; ++request) {
    worker.submit([&delivered, request](const RunContext&) -> Worker::Delivery {
      return [&delivered, request] { delivered.push_back(request); };
    });
    worker.poll();
  }
  gate.open();
  poll_until_idle(worker);
  EXPECT_FALSE(cancelled);
  EXPECT_EQ(delivered, (std::vector<int>{1, 50}));
}

TEST(Worker, GraceEndsInCancellation) {
  Worker worker({}, milliseconds(5));
  Gate never;
  bool delivered = false;
  worker.submit([&](const RunContext& context) -> Worker::Delivery {
    never.wait_open(context);
    return {};
  });
  never.wait_entered();
  worker.submit([&](const RunContext&) -> Worker::Delivery { return [&] { delivered = true; }; });
  poll_until_idle(worker);
  EXPECT_TRUE(delivered);
}

TEST(Worker, ExceptionsArriveAsMessages) {
  Worker worker;
  std::vector<std::string> messages;
  const auto note = [&](const Worker::Failure& failure) {
    EXPECT_FALSE(failure.cancelled);
    messages.push_back(failure.message);
  };
  worker.submit(
      [](const RunContext&) -> Worker::Delivery { throw std::runtime_error("no such line"); },
      note);
  poll_until_idle(worker);
  worker.submit([](const RunContext&) -> Worker::Delivery { throw std::bad_alloc(); }, note);
  poll_until_idle(worker);
  worker.submit([](const RunContext&) -> Worker::Delivery { throw 7; }, note);
  poll_until_idle(worker);
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(messages[0], "no such line");
  EXPECT_NE(messages[1].find("memory"), std::string::npos);
  EXPECT_FALSE(messages[2].empty());
}

TEST(Worker, ExceptionsOfADeliveryGoToItsFailureHandler) {
  Worker worker;
  std::vector<Worker::Failure> failures;
  const auto note = [&](const Worker::Failure& failure) { failures.push_back(failure); };
  const auto deliver_until = [&](std::size_t count) {
    while (failures.size() < count) {
      worker.poll();
      std::this_thread::yield();
    }
  };
  worker.submit(
      [](const RunContext&) -> Worker::Delivery {
        return [] { throw std::runtime_error("no such widget"); };
      },
      note);
  deliver_until(1);
  EXPECT_EQ(failures[0].message, "no such widget");
  worker.submit(
      [](const RunContext&) -> Worker::Delivery { return [] { throw std::bad_alloc(); }; }, note);
  deliver_until(2);
  EXPECT_TRUE(failures[1].out_of_memory);
  EXPECT_FALSE(failures[0].out_of_memory);
}

TEST(Worker, CancelTellsTheLatestRequestEvenIfTheJobFinishesAnyway) {
  Worker worker;
  Gate gate;
  bool delivered = false;
  Worker::Failure told;
  worker.submit(
      [&](const RunContext&) -> Worker::Delivery {
        gate.wait_open(RunContext{});  // ignores the token, so it always finishes
        return [&] { delivered = true; };
      },
      [&](const Worker::Failure& failure) { told = failure; });
  gate.wait_entered();
  worker.cancel();
  gate.open();
  poll_until_idle(worker);
  EXPECT_TRUE(told.cancelled);
  EXPECT_TRUE(told.too_late) << "What it wrote is there.";
  EXPECT_FALSE(delivered);
}

TEST(Worker, AJobThatGaveUpWasCancelledInTime) {
  Worker worker;
  Gate gate;
  Worker::Failure told;
  told.too_late = true;
  worker.submit(
      [&](const RunContext& context) -> Worker::Delivery {
        gate.wait_open(RunContext{});
        context.cancel.throw_if_cancelled();
        return {};
      },
      [&](const Worker::Failure& failure) { told = failure; });
  gate.wait_entered();
  worker.cancel();
  gate.open();
  poll_until_idle(worker);
  EXPECT_TRUE(told.cancelled);
  EXPECT_FALSE(told.too_late);
}

TEST(Worker, CancelOfAWaitingRequestAlsoSilencesTheRunningOne) {
  Worker worker({}, std::chrono::hours(1));
  Gate gate;
  int told_first = 0, told_second = 0, delivered = 0;
  worker.submit(
      [&](const RunContext&) -> Worker::Delivery {
        gate.wait_open(RunContext{});
        return [&] { ++delivered; };
      },
      [&](const Worker::Failure&) { ++told_first; });
  gate.wait_entered();
  worker.submit(
      [&](const RunContext&) -> Worker::Delivery { return [&] { ++delivered; }; },
      [&](const Worker::Failure& failure) { told_second += failure.cancelled ? 1 : 100; });
  worker.cancel();
  gate.open();
  poll_until_idle(worker);
  EXPECT_EQ(told_first, 0);
  EXPECT_EQ(told_second, 1);
  EXPECT_EQ(delivered, 0);
}

TEST(Worker, DestructionCancelsAndJoins) {
  std::atomic<bool> ended{false};
  Gate never;
  bool told = false;
  {
    Worker worker;
    worker.submit(
        [&](const RunContext& context) -> Worker::Delivery {
          struct AtEnd {
            std::atomic<bool>& flag;
            ~AtEnd() { flag = true; }
          } at_end{ended};
          never.wait_open(context);
          return {};
        },
        [&](const Worker::Failure&) { told = true; });
    never.wait_entered();
  }
  EXPECT_TRUE(ended);
  EXPECT_FALSE(told);
}

TEST(Worker, ReportsProgressAndWakes) {
  std::atomic<int> wakes{0};
  Worker worker([&] { ++wakes; });
  Gate gate;
  worker.submit([&](const RunContext& context) -> Worker::Delivery {
    context.report("grid", 0.25);
    gate.wait_open(context);
    return {};
  });
  gate.wait_entered();
  const Worker::Activity activity = worker.activity();
  EXPECT_TRUE(activity.busy);
  EXPECT_EQ(activity.stage, "grid");
  EXPECT_DOUBLE_EQ(activity.share, 0.25);
  gate.open();
  poll_until_idle(worker);
  while (wakes < 2) std::this_thread::yield();  // the last wake follows the hand-over
  EXPECT_FALSE(worker.activity().busy);
  EXPECT_TRUE(worker.activity().stage.empty());
}

TEST(Worker, SubmitStormEndsWithTheLast) {
  Worker worker({}, milliseconds(2));
  int last = -1;
  for (int request = 0; request < 5000; ++request) {
    worker.submit([&last, request](const RunContext& context) -> Worker::Delivery {
      for (int step = 0; step < 100; ++step) context.cancel.throw_if_cancelled();
      return [&last, request] {
        EXPECT_GT(request, last);
        last = request;
      };
    });
    if (request % 7 == 0) worker.poll();
  }
  poll_until_idle(worker);
  EXPECT_EQ(last, 4999);
}

TEST(Worker, ADeliveryMaySubmitAgain) {
  Worker worker;
  int rounds = 0;
  std::function<Worker::Delivery(const RunContext&)> job = [&](const RunContext&) {
    return [&] {
      if (++rounds < 5) worker.submit(job);
    };
  };
  worker.submit(job);
  while (rounds < 5) worker.poll();
  EXPECT_EQ(rounds, 5);
}

}  // namespace
}  // namespace alphascope
