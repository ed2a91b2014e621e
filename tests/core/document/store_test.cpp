// The store of derived results: made once a key, in the background, under a budget.
#include "core/document/store.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "core/document/derived.hpp"
#include "tests/support/five_balls.hpp"

namespace alphascope {
namespace {

using namespace std::chrono_literals;

struct StoreTest : ::testing::Test {
  std::atomic<int> made{0};
  std::atomic<bool> hold{false};  // results are not finished as long as it is set
  std::uint64_t budget = 1000;
  Store store{{}, [this] { return budget; }};

  Definition<int> number(std::string_view id, std::uint64_t bytes = 10, bool keep_stale = true) {
    return {id,
            id,
            [](const Inputs& in) { return in.balls_key; },
            [bytes](const Inputs&) {
              return MemoryNeed{bytes, bytes};
            },
            [this](const Inputs& in, const RunContext& context) {
              ++made;
              while (hold) {
                context.cancel.throw_if_cancelled();
                std::this_thread::sleep_for(1ms);
              }
              return std::make_shared<const int>(static_cast<int>(in.balls_key));
            },
            keep_stale};
  }
  static Inputs inputs(std::uint64_t key) {
    Inputs in;
    in.balls_key = key;
    return in;
  }
  template <class T>
  Derived<T> settle(const Definition<T>& definition, const Inputs& in) {
    Derived<T> d;
    for (int i = 0; i < 5000; ++i) {
      d = store.want(definition, in);
      if (d.state != DerivedState::waiting && d.state != DerivedState::running) return d;
      store.poll();
      std::this_thread::sleep_for(1ms);
    }
    ADD_FAILURE() << "not made in five seconds";
    return d;
  }
};

TEST_F(StoreTest, MakesAResultOncePerKey) {
  const auto n = number("n");
  EXPECT_EQ(store.want(n, inputs(3)).state, DerivedState::waiting);
  EXPECT_EQ(*settle(n, inputs(3)).value, 3);
  EXPECT_EQ(*settle(n, inputs(3)).value, 3);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(*settle(n, inputs(4)).value, 4);
  EXPECT_EQ(made, 2);
  EXPECT_EQ(store.held_bytes(), 10u);
}

TEST_F(StoreTest, InputsThatDoNotSufficeMakeNothing) {
  EXPECT_EQ(settle(number("n"), inputs(0)).state, DerivedState::none);
  EXPECT_EQ(made, 0);
  EXPECT_FALSE(store.busy());
}

TEST_F(StoreTest, TheLastResultStaysUntilTheNextIsThereOrGoesAtOnce) {
  const auto kept = number("kept"), not_kept = number("not kept", 10, false);
  settle(kept, inputs(1));
  settle(not_kept, inputs(1));
  const Derived<int> stale = store.want(kept, inputs(2));
  EXPECT_TRUE(stale.stale());
  EXPECT_EQ(*stale.value, 1);
  EXPECT_FALSE(store.want(not_kept, inputs(2)).value);
}

TEST_F(StoreTest, AnotherKeyEndsWhatIsMadeOfTheLast) {
  hold = true;
  const auto n = number("n");
  while (made == 0) {
    store.want(n, inputs(1));
    store.poll();
  }
  EXPECT_EQ(store.want(n, inputs(1)).state, DerivedState::running);
  store.want(n, inputs(2));
  for (int i = 0; i < 5000 && made < 2; ++i) {  // the first one gives way although it is held
    store.want(n, inputs(2));
    store.poll();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(made, 2);
  hold = false;
  EXPECT_EQ(*settle(n, inputs(2)).value, 2);
}

TEST_F(StoreTest, WhatDoesNotFitIsNotMadeAndSaysSo) {
  budget = 2'000'000'000;
  const Derived<int> d = settle(number("large", 3'000'000'000), inputs(1));
  EXPECT_EQ(d.state, DerivedState::no_room);
  EXPECT_EQ(d.why, "It needs about 3.00 GB of memory, and 2.00 GB is available for it.");
  EXPECT_EQ(made, 0);
  ASSERT_EQ(store.jobs().size(), 1u);
  EXPECT_EQ(store.jobs()[0].state, DerivedState::no_room);
}

TEST_F(StoreTest, WhatNobodyAsksForMakesRoom) {
  const auto first = number("first", 600), second = number("second", 600);
  settle(first, inputs(1));
  EXPECT_EQ(store.want(second, inputs(1)).state, DerivedState::waiting);
  store.want(first, inputs(1));
  store.poll();
  EXPECT_EQ(store.want(second, inputs(1)).state, DerivedState::no_room) << "the first is wanted";
  for (int i = 0; i < 3; ++i) store.poll();
  EXPECT_EQ(settle(second, inputs(2)).state, DerivedState::ready);
  EXPECT_EQ(store.held_bytes(), 600u);
  EXPECT_FALSE(store.want(first, inputs(1)).value);
}

TEST_F(StoreTest, WhatNobodyAsksForAnyMoreIsNotFinished) {
  hold = true;
  const auto n = number("n");
  while (made == 0) {
    store.want(n, inputs(1));
    store.poll();
  }
  for (int i = 0; i < 5000 && store.busy(); ++i) {
    store.poll();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_FALSE(store.busy());
  hold = false;
  EXPECT_EQ(*settle(n, inputs(1)).value, 1) << "asked for again";
}

TEST_F(StoreTest, CancelledIsNotBegunAgain) {
  hold = true;
  const auto n = number("n");
  while (made == 0) {
    store.want(n, inputs(1));
    store.poll();
  }
  store.cancel("n");
  EXPECT_EQ(settle(n, inputs(1)).state, DerivedState::cancelled);
  for (int i = 0; i < 50 || store.busy(); ++i) {
    store.want(n, inputs(1));
    store.poll();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(made, 1);
  hold = false;
  EXPECT_EQ(*settle(n, inputs(2)).value, 2) << "of other inputs";
}

TEST_F(StoreTest, WhatIsLookedAtGoesFirst) {
  std::mutex mutex;
  std::vector<std::string> order;
  const auto noting = [&](std::string_view id) {
    Definition<int> d = number(id);
    d.make = [&, id](const Inputs&, const RunContext&) {
      const std::lock_guard lock(mutex);
      order.emplace_back(id);
      return std::make_shared<const int>(1);
    };
    return d;
  };
  const auto behind = noting("behind"), seen = noting("seen");
  for (int i = 0; i < 5000; ++i) {
    const bool a = store.want(behind, inputs(1), Priority::background).ready();
    if (store.want(seen, inputs(1), Priority::visible).ready() && a) break;
    store.poll();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(order, (std::vector<std::string>{"seen", "behind"}));
}

TEST_F(StoreTest, AFailureIsToldAndNotRepeated) {
  Definition<int> failing = number("failing");
  failing.make = [this](const Inputs&, const RunContext&) -> std::shared_ptr<const int> {
    ++made;
    throw std::runtime_error("The inputs do not match.");
  };
  for (int i = 0; i < 3; ++i) {
    const Derived<int> d = settle(failing, inputs(1));
    EXPECT_EQ(d.state, DerivedState::failed);
    EXPECT_EQ(d.why, "The inputs do not match.");
    store.poll();
  }
  EXPECT_EQ(made, 1);
}

TEST_F(StoreTest, TheFiltrationFollowsFromTheTriangulation) {
  budget = 1'000'000'000;
  Inputs in;
  testing::Random random(1);
  in.balls = std::make_shared<const BallSet>(testing::five_balls(random, 0));
  in.balls_key = 1;
  EXPECT_EQ(store.want(whole_filtration(), in).state, DerivedState::none);
  in.triangulation = settle(whole_triangulation(), in).value;
  ASSERT_TRUE(in.triangulation);
  const auto filtration = settle(whole_filtration(), in).value;
  ASSERT_TRUE(filtration);
  EXPECT_EQ(filtration->top().tetrahedra.size(), in.triangulation->tetrahedra.size());
}

}  // namespace
}  // namespace alphascope
