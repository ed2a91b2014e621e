// SPDX-License-Identifier: GPL-3.0-or-later
// Tests when the next model is due, with time set by the test.
#include "app/viewer/parts/model_playback.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

using namespace std::chrono_literals;
using Clock = ModelPlayback::Clock;

const Clock::time_point kStart{1000s};
constexpr double kPerSecond = 10;

TEST(ModelPlayback, TheFirstModelGetsItsTimeToo) {
  ModelPlayback playback;
  EXPECT_FALSE(playback.next({3, 20, true}, kPerSecond, kStart));
  EXPECT_FALSE(playback.next({3, 20, true}, kPerSecond, kStart + 99ms));
  EXPECT_EQ(playback.next({3, 20, true}, kPerSecond, kStart + 100ms), 4);
}

TEST(ModelPlayback, WaitsForTheAnswerHoweverLongAndQueuesNothing) {
  ModelPlayback playback;
  playback.next({0, 20, true}, kPerSecond, kStart);
  ASSERT_EQ(playback.next({0, 20, true}, kPerSecond, kStart + 100ms), 1);
  for (int tenth = 2; tenth < 50; ++tenth) {
    EXPECT_FALSE(playback.next({1, 20, false}, kPerSecond, kStart + tenth * 100ms));
  }
  // Playback is five seconds late. Exactly one model follows, not fifty.
  EXPECT_EQ(playback.next({1, 20, true}, kPerSecond, kStart + 5s), 2);
  EXPECT_FALSE(playback.next({2, 20, true}, kPerSecond, kStart + 5s + 10ms));
}

TEST(ModelPlayback, StartsAgainAfterTheLast) {
  ModelPlayback playback;
  playback.next({19, 20, true}, kPerSecond, kStart);
  EXPECT_EQ(playback.next({19, 20, true}, kPerSecond, kStart + 1s), 0);
  EXPECT_EQ(playback.next({-1, 20, true}, kPerSecond, kStart + 2s), 0) << "from all at once";
}

TEST(ModelPlayback, OneModelIsNoFilm) {
  ModelPlayback playback;
  playback.next({0, 1, true}, kPerSecond, kStart);
  EXPECT_FALSE(playback.next({0, 1, true}, kPerSecond, kStart + 10s));
}

TEST(ModelPlayback, StoppingForgetsTheClock) {
  ModelPlayback playback;
  playback.next({0, 9, true}, kPerSecond, kStart);
  playback.stop();
  EXPECT_FALSE(playback.next({0, 9, true}, kPerSecond, kStart + 1s)) << "begins anew";
  EXPECT_NEAR(playback.seconds_to_next(kPerSecond, kStart + 1030ms), 0.07, 1e-9);
}

}  // namespace
}  // namespace alphascope
