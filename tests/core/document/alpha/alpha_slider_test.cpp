// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the map of the alpha slider and its playback: inverse, monotone, and never stuck.
#include "core/document/alpha/alpha_slider.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/complex/face_class.hpp"
#include "core/document/alpha/signature.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/amber_radii.hpp"

namespace alphascope {
namespace {

std::vector<AlphaSlider> sliders() {
  std::vector<AlphaSlider> all;
  for (const AlphaScaling scaling :
       {AlphaScaling::linear, AlphaScaling::root, AlphaScaling::logarithm}) {
    all.push_back({scaling, -3, 10});
    all.push_back({scaling, -3, 1e7});
    all.push_back({scaling, 1.4, 1.5});
    all.push_back({scaling, -50, -2});
  }
  return all;
}

TEST(AlphaSlider, PlacesGrowWithAlphaAndComeBack) {
  ASSERT_FALSE(sliders().empty());
  for (const AlphaSlider& s : sliders()) {
    EXPECT_EQ(slider_position_of_alpha(s, s.low), 0);
    EXPECT_EQ(slider_position_of_alpha(s, s.high), 1);
    EXPECT_EQ(slider_position_of_alpha(s, s.low - 1), 0);
    EXPECT_EQ(slider_position_of_alpha(s, 2 * std::fabs(s.high) + 1), 1);
    EXPECT_EQ(alpha_at_slider_position(s, 0, 0.01), s.low);
    EXPECT_EQ(alpha_at_slider_position(s, 1, 0.01), s.high);
    constexpr int kSteps = 230;
    double before = s.low;
    for (int i = 1; i < kSteps; ++i) {
      const double place = i / static_cast<double>(kSteps);
      const double alpha = alpha_at_slider_position(s, place, 1.0 / kSteps);
      EXPECT_GE(alpha, before) << static_cast<int>(s.scaling) << " " << s.high << " " << place;
      EXPECT_NEAR(slider_position_of_alpha(s, alpha), place, 1.0 / kSteps);
      before = alpha;
    }
  }
}

TEST(AlphaSlider, AlphaIsRoundedToWhatAPixelCanTell) {
  const AlphaSlider usual;
  const double alpha =
      alpha_at_slider_position(usual, slider_position_of_alpha(usual, 1.4), 1.0 / 230);
  EXPECT_EQ(alpha, 1.4);
  const double fine =
      alpha_at_slider_position(usual, slider_position_of_alpha(usual, 1.437), 0.1 / 230);
  EXPECT_EQ(fine, 1.437);
  EXPECT_FALSE(std::signbit(
      alpha_at_slider_position(usual, slider_position_of_alpha(usual, -1e-9), 1.0 / 230)));
}

// One extreme value. A linear slider up to it leaves no room for small alphas; the other maps do.
TEST(AlphaSlider, AnExtremeEndLeavesRoomForSmallAlphas) {
  const auto room = [](AlphaScaling scaling) {
    const AlphaSlider s{scaling, -3, 1e6};
    return slider_position_of_alpha(s, 10) - slider_position_of_alpha(s, 0);
  };
  EXPECT_LT(room(AlphaScaling::linear), 1e-4);
  EXPECT_GT(room(AlphaScaling::root), 20 * room(AlphaScaling::linear));
  EXPECT_GT(room(AlphaScaling::logarithm), 0.2);
}

TEST(AlphaSlider, PlayingCrossesItBothWaysAndEnds) {
  ASSERT_FALSE(sliders().empty());
  for (AlphaSlider s : sliders()) {
    for (const bool backwards : {false, true}) {
      double alpha = backwards ? s.high : s.low;
      int pictures = 0;
      for (NextAlpha next; pictures < 2000; ++pictures, alpha = next.alpha) {
        next = next_alpha(s, alpha, backwards);
        if (next.ended) break;
        ASSERT_TRUE(backwards ? next.alpha < alpha : next.alpha > alpha) << alpha;
      }
      EXPECT_EQ(alpha, backwards ? s.low : s.high);
      EXPECT_NEAR(pictures, 260, 30) << static_cast<int>(s.scaling) << " " << s.high;
      s.loop = true;
      EXPECT_EQ(next_alpha(s, alpha, backwards).alpha, backwards ? s.high : s.low);
      EXPECT_FALSE(next_alpha(s, alpha, backwards).ended);
      s.loop = false;
    }
  }
}

TEST(AlphaSlider, PlayingFromOutsideBeginsAtTheNearerEnd) {
  const AlphaSlider s;
  EXPECT_EQ(next_alpha(s, -100, false).alpha, s.low);
  EXPECT_EQ(next_alpha(s, 100, true).alpha, s.high);
  EXPECT_TRUE(next_alpha(s, 100, false).ended);
}

TEST(AlphaSlider, SpeedIsHowFar) {
  AlphaSlider s;
  EXPECT_EQ(next_alpha(s, 1.4, false).alpha, 1.45);  // 13 Å² in 260 pictures
  s.speed = 2;
  EXPECT_EQ(next_alpha(s, 1.4, false).alpha, 1.5);
  EXPECT_EQ(next_alpha(s, 1.4, true).alpha, 1.3);
}

Signature some_signature() {
  Signature signature;
  signature.lattice.digits = 3;
  const auto add = [&](int dimension, double alpha) {
    signature.values[static_cast<std::size_t>(dimension)].push_back(
        signature.lattice.alpha_on_lattice(alpha).nearest_float());
  };
  for (int i = 0; i < 100; ++i) add(0, -3.5);
  for (int i = 0; i < 200; ++i) add(3, i * 0.1);
  add(3, 1e6);
  return signature;
}

TEST(AlphaSlider, FittingLeavesOneOutlierOut) {
  AlphaSlider s;
  fit_range(s, some_signature());
  EXPECT_EQ(s.low, -4);
  EXPECT_GE(s.high, 19);
  EXPECT_LE(s.high, 20);
  const AlphaSlider before = s;
  fit_range(s, {});
  EXPECT_EQ(s, before);
}

TEST(AlphaSlider, CriticalValuesAreCountedWhereTheyAre) {
  const AlphaSlider s{AlphaScaling::linear, -5, 5};
  const std::vector<std::uint32_t> counts = critical_values(s, some_signature(), 10);
  EXPECT_EQ(counts, (std::vector<std::uint32_t>{0, 100, 0, 0, 1, 10, 10, 10, 10, 10}));
  EXPECT_TRUE(critical_values(s, some_signature(), 0).empty());
}

}  // namespace
}  // namespace alphascope
