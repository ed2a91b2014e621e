// SPDX-License-Identifier: GPL-3.0-or-later
// Tests chains of results, each made from the one before. One job makes them, in the lane of the
// waiting result. Also tests results that other code has made.
#include <stdexcept>

#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/memory_need.hpp"
#include "tests/core/document/store/store_fixture.hpp"

namespace alphascope {
namespace {

using namespace std::chrono_literals;

struct StoreChainsTest : testing::StoreTest {
  // Makes a result whose value is its source's plus one.
  template <class T>
  Definition<double> after(std::string_view id, const Definition<T>& source,
                           std::uint64_t bytes = 10) {
    return {{.id = id,
             .title = id,
             .made_of = {&source},
             .key = key_of_balls,
             .memory =
                 [bytes](const Inputs&) {
                   return MemoryNeed{bytes, bytes};
                 },
             .lane = Lane::interactive},
            [this, &source](const Inputs& in, const RunContext& context) {
              ++made;
              wait_while_held(context);
              return std::make_shared<const double>(static_cast<double>(in.of(source)) + 1);
            }};
  }
  void until_made(int count) {
    for (int i = 0; i < 60000 && made < count; ++i) std::this_thread::sleep_for(kShort);
    std::this_thread::sleep_for(20ms);  // another job would have begun by now
  }
};

TEST_F(StoreChainsTest, OneJobMakesAllThatSomebodyWaitsFor) {
  const auto first = table("first");
  const auto second = after("second", first), third = after("third", second);
  store.want(third, inputs(1, 5));
  store.poll();
  until_made(3);
  EXPECT_EQ(made, 3) << "no frame came between them";
  store.poll();
  const Derived<double> last = store.want(third, inputs(1, 5));
  ASSERT_TRUE(last.ready());
  EXPECT_EQ(*last.value, 7);
  EXPECT_EQ(*store.want(second, inputs(1, 5)).value, 6);
  EXPECT_EQ(made, 3);
  EXPECT_EQ(store.times_made("third"), 1u);
  EXPECT_EQ(store.held_bytes(), 30u);
}

TEST_F(StoreChainsTest, WhatIsAwaitedFollowsTheSliderToo) {
  const auto slow = number("slow");
  const auto seen = after("seen", slow);
  hold = true;
  store.want(seen, inputs(1));
  store.want(slow, inputs(1), Priority::background);
  store.poll();
  until_made(1);
  EXPECT_FALSE(store.busy(Lane::background));
  EXPECT_TRUE(store.busy(Lane::interactive));
  // Nobody asks for it any more, so the result for the other balls is made in the background lane.
  store.next_frame();
  store.next_frame();
  store.want(slow, inputs(2), Priority::background);
  EXPECT_TRUE(store.busy(Lane::interactive)) << "it runs where it was begun";
  for (int i = 0; i < 60000 && made < 2; ++i) {
    store.want(slow, inputs(2), Priority::background);
    frame();
    std::this_thread::sleep_for(kShort);
  }
  EXPECT_TRUE(store.busy(Lane::background));
  hold = false;
}

TEST_F(StoreChainsTest, WhatTakesMuchRoomIsMadeByItself) {
  const auto first = table("first", 100);
  const auto second = after("second", first, 800);  // more than half of the rest
  store.want(second, inputs(1, 5));
  store.poll();
  until_made(1);
  EXPECT_EQ(made, 1);
  const Derived<double> d = settle(second, inputs(1, 5));
  EXPECT_EQ(d.state, DerivedState::ready);
  EXPECT_EQ(*d.value, 6);
}

TEST_F(StoreChainsTest, AFailureInTheMiddleIsToldAndWhatIsBeforeItStays) {
  const auto first = table("first");
  Definition<double> second = after("second", first);
  int tried = 0;
  second.make = [&tried](const Inputs&, const RunContext&) -> std::shared_ptr<const double> {
    ++tried;
    throw std::runtime_error("There is no such number.");
  };
  const Derived<double> d = settle(second, inputs(1, 5));
  EXPECT_EQ(d.state, DerivedState::failed);
  EXPECT_EQ(d.why, "There is no such number.");
  EXPECT_TRUE(store.want(first, inputs(1, 5)).ready());
  EXPECT_EQ(made, 1);
  EXPECT_LE(tried, 2);
}

TEST_F(StoreChainsTest, OtherBallsEndAllOfIt) {
  const auto first = table("first");
  const auto second = after("second", first);
  hold = true;
  begin(second, inputs(1, 5));
  EXPECT_EQ(made, 1);
  hold = false;
  EXPECT_EQ(*settle(second, inputs(2, 7)).value, 8);
  EXPECT_EQ(store.want(second, inputs(2, 7)).have.balls, 2u);
}

TEST_F(StoreChainsTest, NothingIsBegunInABackgroundThatIsHeld) {
  const auto slow = number("slow");
  store.hold_background(true);
  for (int i = 0; i < 20; ++i) {
    store.want(slow, inputs(1));
    frame();
    std::this_thread::sleep_for(kShort);
  }
  EXPECT_EQ(made, 0);
  store.hold_background(false);
  EXPECT_EQ(*settle(slow, inputs(1)).value, 1);
}

TEST_F(StoreChainsTest, WhatIsGivenIsNotMade) {
  const auto slow = number("slow");
  const auto seen = after("seen", slow);
  store.give(slow, inputs(1), std::make_shared<const int>(40));
  const Derived<int> given = store.want(slow, inputs(1));
  ASSERT_TRUE(given.ready());
  EXPECT_EQ(*given.value, 40);
  EXPECT_EQ(*settle(seen, inputs(1)).value, 41);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(store.held_bytes(), 20u);
  store.give(slow, inputs(1), std::make_shared<const int>(50));
  EXPECT_EQ(*store.want(slow, inputs(1)).value, 40) << "it is there already";
  store.give(slow, inputs(2), std::shared_ptr<const int>());
  EXPECT_FALSE(store.want(slow, inputs(2)).ready());
}

TEST_F(StoreChainsTest, WhatIsThereCanBeHadWithoutAWish) {
  const auto slow = number("slow");
  EXPECT_EQ(store.have(slow, inputs(1)), nullptr);
  EXPECT_FALSE(store.busy()) << "nobody wants it";
  store.give(slow, inputs(1), std::make_shared<const int>(40));
  const auto had = store.have(slow, inputs(1));
  ASSERT_TRUE(had);
  EXPECT_EQ(*had, 40);
  EXPECT_EQ(store.have(slow, inputs(2)), nullptr) << "of other balls";
  EXPECT_EQ(store.have(slow, Inputs{}), nullptr) << "of none";
  store.want(slow, inputs(2));
  EXPECT_EQ(store.have(slow, inputs(1)), had) << "it has not made room yet";
}

TEST_F(StoreChainsTest, WhatIsGivenEndsItsOwnMaking) {
  const auto slow = number("slow");
  hold = true;
  begin(slow, inputs(1));
  store.give(slow, inputs(1), std::make_shared<const int>(40));
  EXPECT_TRUE(store.want(slow, inputs(1)).ready());
  for (int i = 0; i < 60000 && store.busy(); ++i) {
    store.want(slow, inputs(1));
    frame();
    std::this_thread::sleep_for(kShort);
  }
  EXPECT_FALSE(store.busy()) << "it was held, so it must have given way";
  EXPECT_EQ(*store.want(slow, inputs(1)).value, 40);
}

TEST_F(StoreChainsTest, WhatIsGivenWithoutRoomIsDropped) {
  const auto large = number("large", 2000);
  store.give(large, inputs(1), std::make_shared<const int>(40));
  EXPECT_EQ(settle(large, inputs(1)).state, DerivedState::no_room);
  EXPECT_EQ(store.held_bytes(), 0u);
}

}  // namespace
}  // namespace alphascope
