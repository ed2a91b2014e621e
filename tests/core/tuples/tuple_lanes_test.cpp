// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the order of the tuple pipeline on an executor with several lanes. They run as late as
// possible, as streams of a device may. A missing wait gives a wrong complex.
#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <functional>

#include "core/tuples/tuple_compute.hpp"
#include "core/tuples/tuple_engine.hpp"
#include "tests/support/random_balls.hpp"
#include "tests/support/sanitizer.hpp"

namespace alphascope {
namespace {

// Calls wait in their lane's queue until the lane is needed. Each lane is a stream, which nothing
// orders with the others.
class LateExecutor {
 public:
  using Reader = PlainReader;
  static constexpr bool kOnGpu = true;

  // Growing frees the old memory. A device waits for all its work before that.
  template <class T>
  class Buffer {
   public:
    void reserve(std::uint64_t count) {
      if (count <= data_.size()) return;
      running_->run_all();
      data_.assign(count, T{});
    }
    T* get() { return data_.data(); }

   private:
    std::vector<T> data_;
  };

  explicit LateExecutor(const TupleOptions& options)
      : options_(options), queues_(static_cast<std::size_t>(options.streams) + 1) {
    running_ = this;
  }
  std::uint64_t capacity() const { return static_cast<std::uint64_t>(options_.tuples_per_batch); }
  std::size_t workers() const { return static_cast<std::size_t>(options_.streams); }
  std::pmr::memory_resource* host_memory() const { return std::pmr::new_delete_resource(); }
  TupleUpload<PlainReader> upload(const TupleGrid& grid) const {
    return {{grid.records.data(), grid.reach.data()}, grid.cell_start.data(), grid.ball.data()};
  }
  template <class Body>
  void for_each(int lane, std::uint64_t count, const Body& body) {
    later(lane, [=] {
      for (std::uint64_t n = count; n-- > 0;) body(n);  // in any order
    });
  }
  template <class Body>
  void for_each_of(int lane, const std::uint64_t* count, std::uint64_t, const Body& body) {
    later(lane, [=] {
      for (std::uint64_t n = 0; n < *count; ++n) body(n);
    });
  }
  template <class Value>
  void prefix_sum(int lane, std::uint64_t count, const Value& value, std::uint64_t* sums) {
    later(lane, [=] {
      sums[0] = 0;
      for (std::uint64_t n = 0; n < count; ++n) sums[n + 1] = sums[n] + value(n);
    });
  }
  template <class Value>
  std::uint64_t sum(int lane, std::uint64_t count, const Value& value) {
    run(lane);
    std::uint64_t total = 0;
    for (std::uint64_t n = 0; n < count; ++n) total += value(n);
    return total;
  }
  template <class T>
  T read(int lane, const T* from) {
    run(lane);
    return *from;
  }
  template <class T>
  void fetch(int lane, const T* from, std::uint64_t count, ResultArray<T>& to) {
    later(lane, [=, &to] { to.insert(to.end(), from, from + count); });
  }
  void wait(int lane) { run(lane); }
  void reset() {
    for (auto& q : queues_) q.clear();
  }
  void begin(int, std::string_view) {}
  void end(int) {}
  StageTimes take_times() { return {}; }
  bool idle() const {
    return std::all_of(queues_.begin(), queues_.end(), [](const auto& q) { return q.empty(); });
  }

  std::size_t most_busy_lanes = 0;

 private:
  void later(int lane, std::function<void()> call) {
    queues_[static_cast<std::size_t>(lane)].push_back(std::move(call));
    const auto busy =
        std::count_if(queues_.begin(), queues_.end(), [](const auto& q) { return !q.empty(); });
    most_busy_lanes = std::max(most_busy_lanes, static_cast<std::size_t>(busy));
  }
  void run(int lane) {
    auto& queue = queues_[static_cast<std::size_t>(lane)];
    while (!queue.empty()) {
      queue.front()();
      queue.pop_front();
    }
  }
  void run_all() {
    for (std::size_t lane = 0; lane < queues_.size(); ++lane) run(static_cast<int>(lane));
  }

  inline static LateExecutor* running_ = nullptr;
  const TupleOptions options_;
  std::vector<std::deque<std::function<void()>>> queues_;
};

TEST(TupleLanes, NeedNoOtherOrderThanTheirOwn) {
  testing::Random random(51);
  for (const testing::NamedBalls& set :
       testing::large_hard_sets(random, testing::unless_sanitized(60, 20))) {
    SCOPED_TRACE(set.name);
    if (set.name == "extremes of the lattice") continue;
    const auto balls = std::make_shared<const BallSet>(set.balls);
    const double alpha = set.name == "random" ? 1e5 : 2;
    for (const int streams : {1, 2, 5}) {
      for (const int batch : {1, 40, 100000}) {
        TupleOptions options;
        options.streams = streams;
        options.tuples_per_batch = batch;
        LateExecutor executor(options);
        TupleComputer<LateExecutor> computer(balls, options, executor);
        const auto expected = make_tuple_engine(balls, {1});
        for (const double a : {alpha, alpha / 2, alpha}) {  // reuses buffers
          const AlphaComplex found = computer.compute({a}, {}), same = expected->compute({a}, {});
          EXPECT_EQ(found.hash, same.hash);
          EXPECT_EQ(found.tetrahedra.alpha_values, same.tetrahedra.alpha_values);
          EXPECT_EQ(found.triangles.alpha_values, same.triangles.alpha_values);
          EXPECT_EQ(found.vertices.classes, same.vertices.classes);
          EXPECT_TRUE(executor.idle()) << "something was left under way";
        }
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
}

// Counts lanes that have work at the same time. If each batch were awaited before the next starts,
// several streams would be useless.
TEST(TupleLanes, WorkSideBySide) {
  testing::Random random(52);
  const auto balls =
      std::make_shared<const BallSet>(testing::random_balls(random, 60, 1000, 300, 400));
  TupleOptions options;
  options.streams = 3;
  options.tuples_per_batch = 2000;
  options.alpha_optimisation = false;
  LateExecutor executor(options);
  TupleComputer<LateExecutor> computer(balls, options, executor);
  computer.compute({1e6}, {});  // buffers grow, and all lanes are awaited
  executor.most_busy_lanes = 0;
  EXPECT_GT(computer.compute({1e6}, {}).tetrahedra.size(), 10u);
  EXPECT_GE(executor.most_busy_lanes, 3u);
}

}  // namespace
}  // namespace alphascope
