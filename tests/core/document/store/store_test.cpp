// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the store of derived results: made once a key, in the background, under a budget.
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/run/cancel_token.hpp"
#include "tests/core/document/store/store_fixture.hpp"

#include <mutex>
#include <new>
#include <stdexcept>
#include <vector>

namespace alphascope {
namespace {

using namespace std::chrono_literals;

using testing::StoreTest;

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
  begin(n, inputs(1));
  EXPECT_EQ(store.want(n, inputs(1)).state, DerivedState::running);
  store.want(n, inputs(2));
  for (int i = 0; i < 60000 && made < 2; ++i) {  // the first one is cancelled although it is held
    store.want(n, inputs(2));
    frame();
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
  EXPECT_EQ(d.why, "This result needs about 3.00 GB of memory, and 2.00 GB is available.");
  EXPECT_EQ(made, 0);
  ASSERT_EQ(store.jobs().size(), 1u);
  EXPECT_EQ(store.jobs()[0].state, DerivedState::no_room);
}

TEST_F(StoreTest, WhatNobodyAsksForMakesRoom) {
  const auto first = number("first", 600), second = number("second", 600);
  settle(first, inputs(1));
  EXPECT_EQ(store.want(second, inputs(1)).state, DerivedState::waiting);
  store.want(first, inputs(1));
  frame();
  EXPECT_EQ(store.want(second, inputs(1)).state, DerivedState::no_room) << "the first is wanted";
  for (int i = 0; i < 3; ++i) frame();
  EXPECT_EQ(settle(second, inputs(2)).state, DerivedState::ready);
  EXPECT_EQ(store.held_bytes(), 600u);
  EXPECT_FALSE(store.want(first, inputs(1)).value);
}

TEST_F(StoreTest, WhatOthersHoldLeavesLessAndWhatWasTooLargeIsTriedAgain) {
  const auto n = number("n", 600);
  store.set_held_bytes("complexes", 300);
  store.set_held_bytes("meshes", 200);
  EXPECT_EQ(store.held_bytes(), 500u);
  EXPECT_EQ(settle(n, inputs(1)).state, DerivedState::no_room);
  frame();
  EXPECT_EQ(settle(n, inputs(1)).state, DerivedState::no_room);
  store.set_held_bytes("meshes", 100);
  store.next_frame();
  EXPECT_TRUE(store.poll()) << "the panel must be drawn, to ask again";
  EXPECT_TRUE(settle(n, inputs(1)).ready());
  EXPECT_EQ(made, 1);
}

TEST_F(StoreTest, WhatIsLookedAtTakesTheRoomOfTheBackground) {
  const auto behind = number("behind", 600), seen = number("seen", 600);
  for (int i = 0; i < 60000 && !store.want(behind, inputs(1), Priority::background).ready(); ++i) {
    frame();
    std::this_thread::sleep_for(kShort);
  }
  for (int i = 0; i < 60000 && !store.want(seen, inputs(1)).ready(); ++i) {
    store.want(behind, inputs(1), Priority::background);
    frame();
    std::this_thread::sleep_for(kShort);
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(store.want(seen, inputs(1)).ready());
    store.want(behind, inputs(1), Priority::background);
    frame();
  }
  const Derived<int> d = store.want(behind, inputs(1), Priority::background);
  EXPECT_EQ(d.state, DerivedState::no_room);
  EXPECT_FALSE(d.value);
}

TEST_F(StoreTest, WhatRunsHasItsRoom) {
  hold = true;
  begin(number("behind", 600), inputs(1));
  store.want(number("behind", 600), inputs(1));
  EXPECT_EQ(settle(table("table", 600), inputs(1, 1)).state, DerivedState::no_room);
  hold = false;
}

TEST_F(StoreTest, OlderAlphasMakeRoomFirst) {
  const auto t = table("table", 300);
  settle(t, inputs(1, 1));
  settle(t, inputs(1, 2));
  settle(t, inputs(1, 3));
  hold = true;
  begin(t, inputs(1, 4));
  EXPECT_EQ(store.held_bytes(), 600u) << "of three";
  EXPECT_EQ(*store.want(t, inputs(1, 4)).value, 3);
  hold = false;
  settle(t, inputs(1, 4));
  const int before = made;
  EXPECT_TRUE(settle(t, inputs(1, 2)).ready());
  EXPECT_EQ(made, before) << "the oldest one went";
}

TEST_F(StoreTest, WhereMemoryRanOutItIsTriedAgainWithMuchMore) {
  Definition<int> greedy = number("greedy", 100);
  greedy.make = [this](const Inputs&, const RunContext&) -> std::shared_ptr<const int> {
    if (++made == 1) throw std::bad_alloc();
    return std::make_shared<const int>(7);
  };
  EXPECT_EQ(settle(greedy, inputs(1)).state, DerivedState::no_room);
  budget = 1200;  // 1000 was not enough
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(settle(greedy, inputs(1)).state, DerivedState::no_room);
    frame();
  }
  EXPECT_EQ(made, 1);
  settle(greedy, inputs(1));
  budget = 1250;
  frame();
  const Derived<int> d = settle(greedy, inputs(1));
  ASSERT_TRUE(d.ready()) << d.why;
  EXPECT_EQ(*d.value, 7);
}

TEST_F(StoreTest, WhatNobodyAsksForAnyMoreIsNotFinished) {
  hold = true;
  const auto n = number("n");
  begin(n, inputs(1));
  for (int i = 0; i < 60000 && store.busy(); ++i) {
    frame();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_FALSE(store.busy());
  hold = false;
  EXPECT_EQ(*settle(n, inputs(1)).value, 1) << "asked for again";
}

TEST_F(StoreTest, CancelledIsNotBegunAgain) {
  hold = true;
  const auto n = number("n");
  begin(n, inputs(1));
  store.cancel("n");
  EXPECT_EQ(settle(n, inputs(1)).state, DerivedState::cancelled);
  for (int i = 0; i < 50 || store.busy(); ++i) {
    store.want(n, inputs(1));
    frame();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(made, 1);
  hold = false;
  EXPECT_EQ(*settle(n, inputs(2)).value, 2) << "of other inputs";
}

TEST_F(StoreTest, ACancelledSourceIsBegunAgainWithItsResult) {
  hold = true;
  const auto source = number("source");
  auto whole = number("whole");
  whole.made_of = {&source};
  begin(whole, inputs(1));
  store.cancel("source");
  EXPECT_EQ(settle(whole, inputs(1)).state, DerivedState::cancelled);
  hold = false;
  store.retry("whole");
  EXPECT_EQ(settle(whole, inputs(1)).state, DerivedState::cancelled) << "its source still is";
  store.retry_whole(whole);
  EXPECT_EQ(*settle(whole, inputs(1)).value, 1);
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
  for (int i = 0; i < 60000; ++i) {
    const bool a = store.want(behind, inputs(1), Priority::background).ready();
    if (store.want(seen, inputs(1), Priority::visible).ready() && a) break;
    frame();
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
    frame();
  }
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace alphascope
