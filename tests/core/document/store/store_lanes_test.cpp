// SPDX-License-Identifier: GPL-3.0-or-later
// Tests results that follow a slider, beside those of the background, and results with sources.
#include <algorithm>
#include <cmath>
#include <future>
#include <mutex>
#include <set>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/run/parallel.hpp"
#include "core/run/work_threads.hpp"
#include "core/triangulation/memory_need.hpp"
#include "tests/core/document/store/store_fixture.hpp"

namespace alphascope {
namespace {

using namespace std::chrono_literals;

struct StoreLanesTest : testing::StoreTest {
  // Values shown while a slider moves in each frame and each result takes some frames.
  std::vector<double> drag(Definition<double> definition, int steps) {
    std::atomic<int> step{0};
    constexpr int kFramesEach = 3;
    definition.make = [&step](const Inputs& in, const RunContext& context) {
      for (const int from = step; step < from + kFramesEach;) {
        context.cancel.throw_if_cancelled();
        std::this_thread::yield();
      }
      return std::make_shared<const double>(in.alpha_angstrom2);
    };
    std::vector<double> shown;
    for (step = 0; step < steps; ++step) {
      const Derived<double> d = store.want(definition, inputs(1, step));
      if (d.value && (shown.empty() || shown.back() != *d.value)) shown.push_back(*d.value);
      frame();
      std::this_thread::sleep_for(kShort);
    }
    step = 1 << 20;  // now the last one is finished
    for (int i = 0; i < 60000 && store.busy(); ++i) {
      frame();
      std::this_thread::sleep_for(kShort);
    }
    return shown;
  }
};

TEST_F(StoreLanesTest, AMovingSliderStarvesNothing) {
  const std::vector<double> shown = drag(table("table"), 100);
  EXPECT_GE(shown.size(), 10u);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  Definition<double> behind = table("behind");
  behind.lane = Lane::background;
  EXPECT_LE(drag(behind, 100).size(), 1u) << "the drag is too slow to starve anything";
}

TEST_F(StoreLanesTest, TheLastAlphaIsMadeAtLast) {
  const auto t = table("table");
  hold = true;
  begin(t, inputs(1, 1));
  for (const double alpha : {2, 3, 4}) {
    const Derived<double> d = store.want(t, inputs(1, alpha));
    EXPECT_EQ(d.state, DerivedState::waiting);
    EXPECT_FALSE(d.value);
    frame();
  }
  hold = false;
  EXPECT_EQ(*settle(t, inputs(1, 4)).value, 4);
  EXPECT_EQ(made, 2) << "one running and one waiting";
}

TEST_F(StoreLanesTest, SaysWhichLaneIsBusy) {
  const auto slow = number("slow");
  const auto t = table("table");
  hold = true;
  begin(slow, inputs(1));
  EXPECT_TRUE(store.busy(Lane::background));
  EXPECT_FALSE(store.busy(Lane::interactive));
  store.want(t, inputs(1, 1));
  EXPECT_TRUE(store.busy(Lane::interactive));
  hold = false;
  settle(t, inputs(1, 1));
  EXPECT_FALSE(store.busy(Lane::interactive));
  hold = true;
  store.want(t, inputs(1, 2));
  for (int i = 0; i < 3; ++i) frame();
  EXPECT_FALSE(store.busy(Lane::interactive)) << "nobody asks for it any more";
  hold = false;
}

TEST_F(StoreLanesTest, AnAlphaThatReturnsIsNotMadeAgain) {
  const auto t = table("table");
  for (const double alpha : {1.0, 2.0, 0.0, 2.0, 1.0, -0.0}) {
    EXPECT_EQ(*settle(t, inputs(1, alpha)).value, alpha);
  }
  EXPECT_EQ(made, 3);
  settle(t, inputs(2, 1));
  EXPECT_EQ(made, 4) << "of other balls";
}

TEST_F(StoreLanesTest, AnAlphaThatReturnsEndsWhatItNoLongerNeeds) {
  const auto t = table("table");
  settle(t, inputs(1, 1));
  hold = true;
  begin(t, inputs(1, 2));
  EXPECT_TRUE(store.want(t, inputs(1, 1)).ready());
  for (int i = 0; i < 60000 && store.busy(); ++i) {
    store.want(t, inputs(1, 1));
    frame();
    std::this_thread::sleep_for(kShort);
  }
  EXPECT_FALSE(store.busy()) << "it was held, so it must have given way";
  EXPECT_EQ(*store.want(t, inputs(1, 1)).value, 1);
}

TEST_F(StoreLanesTest, OneThatIsMadeAgainAfterAllIsTaken) {
  const auto t = table("table");
  hold = true;
  begin(t, inputs(1, 1));
  store.want(t, inputs(1, 2));
  EXPECT_EQ(store.want(t, inputs(1, 1)).state, DerivedState::running);
  hold = false;
  EXPECT_EQ(*settle(t, inputs(1, 1)).value, 1);
  EXPECT_EQ(made, 1);
}

TEST_F(StoreLanesTest, AFailureAtAnAlphaThatReturnedIsNotRepeated) {
  Definition<double> t = table("table");
  t.make = [this](const Inputs&, const RunContext& context) -> std::shared_ptr<const double> {
    ++made;
    wait_while_held(context);
    throw std::runtime_error("The inputs do not match.");
  };
  hold = true;
  begin(t, inputs(1, 1));
  store.want(t, inputs(1, 2));
  EXPECT_EQ(store.want(t, inputs(1, 1)).state, DerivedState::running);
  hold = false;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(settle(t, inputs(1, 1)).state, DerivedState::failed);
    frame();
  }
  EXPECT_EQ(made, 1);
}

TEST_F(StoreLanesTest, OtherBallsEndWhatRuns) {
  const auto t = table("table");
  settle(t, inputs(1, 1));
  hold = true;
  begin(t, inputs(1, 2));
  begin(t, inputs(2, 2));  // the running one is cancelled although it is held
  EXPECT_EQ(made, 3);
  hold = false;
  EXPECT_EQ(*settle(t, inputs(2, 2)).value, 2);
}

TEST_F(StoreLanesTest, ResultsTakeTurnsUnderTheSlider) {
  const auto a = table("a"), b = table("b");
  std::set<double> of_a, of_b;
  for (int i = 0; i < 60000 && (of_a.size() < 5 || of_b.size() < 5); ++i) {
    const auto x = store.want(a, inputs(1, i)), y = store.want(b, inputs(1, i));
    if (x.value) of_a.insert(*x.value);
    if (y.value) of_b.insert(*y.value);
    frame();
    std::this_thread::sleep_for(kShort);
  }
  EXPECT_GE(of_a.size(), 5u);
  EXPECT_GE(of_b.size(), 5u);
}

TEST_F(StoreLanesTest, TheBackgroundHoldsUpNobody) {
  hold = true;
  begin(number("behind"), inputs(1));
  Definition<double> t = table("table");
  t.make = [](const Inputs& in, const RunContext&) {
    return std::make_shared<const double>(in.alpha_angstrom2);
  };
  EXPECT_EQ(*settle(t, inputs(1, 3)).value, 3);
  EXPECT_TRUE(hold);
  store.want(number("behind"), inputs(1));
  ASSERT_EQ(store.jobs().size(), 1u);
  EXPECT_EQ(store.jobs()[0].lane, Lane::background);
}

TEST_F(StoreLanesTest, TheBackgroundHasOneThread) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  Definition<int> n = number("n");
  n.make = [&](const Inputs&, const RunContext&) {
    parallel_each(0, 200u, [&](unsigned) {
      std::this_thread::sleep_for(100us);
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
    return std::make_shared<const int>(1);
  };
  settle(n, inputs(1));
  EXPECT_EQ(threads.size(), 1u);
}

TEST_F(StoreLanesTest, TheSlidersThreadsAreShared) {
  const auto threads = std::make_shared<WorkThreads>(2);
  Store sharing(
      {}, [this] { return budget; }, [&] { return threads; });
  std::atomic<int> at_work{0}, most{0};
  const auto work = [&] {
    parallel_ranges(0, 100u, 1, [&](unsigned, unsigned) {
      const int now = ++at_work;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(200us);
      --at_work;
    });
  };
  Definition<double> t = table("table");
  t.make = [&](const Inputs&, const RunContext&) {
    work();
    return std::make_shared<const double>(1);
  };
  const auto engine = std::async(std::launch::async, [&] { threads->run(work); });
  for (int i = 0; i < 60000 && !sharing.want(t, inputs(1, 1)).ready(); ++i) {
    sharing.next_frame();
    sharing.poll();
    std::this_thread::sleep_for(kShort);
  }
  engine.wait();
  EXPECT_TRUE(sharing.want(t, inputs(1, 1)).ready());
  EXPECT_LE(most, 2);
  EXPECT_GE(most, 1);
}

// --- results with sources

struct StoreChainTest : testing::StoreTest {
  const Definition<int> ground = number("ground");
  const Definition<double> moving = table("moving");
  // Depends on alpha only through `moving`.
  const Definition<double> sum{
      {.id = "sum",
       .title = "Sum",
       .made_of = {&ground, &moving},
       .key = key_of_balls,
       .memory =
           [this](const Inputs& in) {
             const auto bytes = static_cast<std::uint64_t>(in.of(ground));
             return MemoryNeed{bytes, bytes};
           },
       .lane = Lane::interactive},
      [this](const Inputs& in, const RunContext&) {
        return std::make_shared<const double>(in.of(ground) + in.of(moving));
      }};
};

TEST_F(StoreChainTest, WhatAResultIsMadeOfIsMadeFirst) {
  EXPECT_EQ(store.want(sum, inputs(5, 0.5)).state, DerivedState::waiting);
  EXPECT_EQ(store.want(sum, inputs(5, 0.5)).why, "ground");
  EXPECT_EQ(*settle(sum, inputs(5, 0.5)).value, 5.5);
  EXPECT_EQ(made, 2);
  EXPECT_EQ(*settle(sum, inputs(5, 2.5)).value, 7.5) << "by the key of what it is made of";
  EXPECT_EQ(made, 3) << "the ground is the same";
  EXPECT_EQ(store.held_bytes(), 10u + 2 * 10u + 2 * 5u);
}

TEST_F(StoreChainTest, WhatItIsMadeOfMayGoOnceItIsMade) {
  settle(sum, inputs(5, 0.5));
  budget = 5;
  Definition<int> other = number("other", 1);
  for (int i = 0; i < 3; ++i) {
    store.want(sum, inputs(5, 0.5));
    frame();
  }
  budget = 6;
  EXPECT_TRUE(settle(other, inputs(5)).ready());
  EXPECT_TRUE(store.want(sum, inputs(5, 0.5)).ready());
  EXPECT_EQ(store.held_bytes(), 6u);
}

TEST_F(StoreChainTest, TroubleIsToldAlongTheChain) {
  Definition<int> failing = ground;
  failing.make = [](const Inputs&, const RunContext&) -> std::shared_ptr<const int> {
    throw std::runtime_error("There are no balls.");
  };
  Definition<double> of_sum = sum;
  of_sum.id = "of sum";
  of_sum.made_of = {&sum};
  Definition<double> of_failing = sum;
  of_failing.made_of = {&failing};
  of_sum.made_of = {&of_failing};
  const Derived<double> d = settle(of_sum, inputs(5, 1));
  EXPECT_EQ(d.state, DerivedState::failed);
  EXPECT_EQ(d.why, "ground: There are no balls.");
  ASSERT_EQ(store.jobs().size(), 1u) << "told once";
  EXPECT_EQ(store.jobs()[0].title, "ground");
}

TEST_F(StoreChainTest, NoRoomPassesWhenThereIsSome) {
  budget = 9;
  const Derived<double> d = settle(sum, inputs(5, 1));
  EXPECT_EQ(d.state, DerivedState::no_room);
  EXPECT_EQ(d.why.substr(0, 35), "ground: This result needs about 0.0") << d.why;
  budget = 1000;
  frame();
  EXPECT_EQ(*settle(sum, inputs(5, 1)).value, 6);
}

TEST_F(StoreChainTest, WhatIsNotNamedCannotBeUsed) {
  Definition<double> hiding = sum;
  hiding.made_of = {&moving};
  const Derived<double> d = settle(hiding, inputs(5, 1));
  EXPECT_EQ(d.state, DerivedState::failed);
  EXPECT_NE(d.why.find("asks for \"ground\", which its definition does not name"),
            std::string::npos)
      << d.why;
}

TEST_F(StoreChainTest, AResultHoldsNoComplexThatItIsNotOf) {
  const auto complex = std::make_shared<const AlphaComplex>();
  Inputs in = inputs(5, 1);
  in.complex = complex;
  std::atomic<bool> had_complex{true}, had_alpha{true};
  Definition<int> of_balls = ground;
  of_balls.make = [&](const Inputs& got, const RunContext&) {
    had_complex = got.complex != nullptr;
    had_alpha = !std::isnan(got.alpha_angstrom2);
    return std::make_shared<const int>(1);
  };
  settle(of_balls, in);
  EXPECT_FALSE(had_complex);
  EXPECT_FALSE(had_alpha);
  Definition<int> of_complex = of_balls;
  of_complex.id = "of complex";
  of_complex.key = key_of_complex;
  settle(of_complex, in);
  EXPECT_TRUE(had_complex);
  EXPECT_TRUE(had_alpha);
  in.complex = nullptr;
  EXPECT_EQ(store.want(of_complex, in).state, DerivedState::none);
}

TEST(StoreLanes, GoesWhileBothLanesRun) {
  std::atomic<int> begun{0}, ended{0};
  const auto until_cancelled = [&](const Inputs&, const RunContext& context) {
    ++begun;
    while (!context.cancel.cancelled()) std::this_thread::sleep_for(1ms);
    ++ended;
    return std::make_shared<const int>(1);
  };
  {
    Store store({}, [] { return std::uint64_t{1000}; });
    AnyDefinition about{.id = "behind", .title = "behind", .key = key_of_balls, .memory = {}};
    about.memory = [](const Inputs&) { return MemoryNeed{}; };
    const Definition<int> behind(about, until_cancelled);
    about.id = "before";
    about.lane = Lane::interactive;
    const Definition<int> before(about, until_cancelled);
    Inputs in;
    in.balls_key = 1;
    while (begun < 2) {
      store.want(behind, in);
      store.want(before, in);
      store.poll();
    }
  }
  EXPECT_EQ(ended, 2);
}

}  // namespace
}  // namespace alphascope
