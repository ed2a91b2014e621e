// SPDX-License-Identifier: GPL-3.0-or-later
// Tests colour maps, scales, and their round numbers.
#include "core/chart/colour_scale.hpp"
#include "core/molecule/rgb8.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

double brightness(const Rgb8& c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

TEST(ColourMap, EndsAreThoseOfTheTablesAndNothingIsBeyond) {
  EXPECT_EQ(mapped_colour(ColourMap::viridis, 0), (Rgb8{68, 1, 84}));
  EXPECT_EQ(mapped_colour(ColourMap::cividis, 1), (Rgb8{254, 232, 56}));
  EXPECT_EQ(mapped_colour(ColourMap::blue_white_red, 0.5), (Rgb8{247, 247, 247}));
  EXPECT_EQ(mapped_colour(ColourMap::rainbow, 1), (Rgb8{218, 34, 34}));
  for (const ColourMap map : kColourMaps) {
    EXPECT_EQ(mapped_colour(map, -1), mapped_colour(map, 0));
    EXPECT_EQ(mapped_colour(map, 2), mapped_colour(map, 1));
    EXPECT_EQ(mapped_colour(map, std::nan("")), mapped_colour(map, 0));
    EXPECT_EQ(colour_map_named(colour_map_info(map).id), map);
  }
  EXPECT_FALSE(colour_map_named("jet"));
}

// Entries of the published tables: both ends and two between them.
TEST(ColourMap, EntriesArePublishedOnes) {
  const struct {
    ColourMap map;
    double entries;
    struct {
      double number;
      Rgb8 colour;
    } some[4];
  } tables[] = {
      {ColourMap::viridis,
       9,
       {{0, {68, 1, 84}}, {3, {44, 113, 142}}, {6, {92, 200, 99}}, {8, {253, 231, 37}}}},
      {ColourMap::cividis,
       9,
       {{0, {0, 34, 78}}, {2, {67, 78, 108}}, {5, {155, 148, 118}}, {8, {254, 232, 56}}}},
      {ColourMap::blue_white_red,
       11,
       {{0, {5, 48, 97}}, {3, {146, 197, 222}}, {8, {214, 96, 77}}, {10, {103, 0, 31}}}},
      {ColourMap::rainbow,
       22,
       {{0, {111, 76, 155}}, {7, {89, 165, 169}}, {15, {221, 170, 60}}, {21, {218, 34, 34}}}}};
  for (const auto& table : tables) {
    for (const auto& [number, colour] : table.some) {
      EXPECT_EQ(mapped_colour(table.map, number / (table.entries - 1)), colour)
          << colour_map_info(table.map).id << ' ' << number;
    }
  }
}

TEST(ColourMap, SequentialOnesGrowBrighterAndTheDivergingOneIsBrightestInItsMiddle) {
  for (int i = 0; i < 100; ++i) {
    const double a = i / 100.0, b = (i + 1) / 100.0;
    for (const ColourMap map : {ColourMap::viridis, ColourMap::cividis}) {
      EXPECT_LT(brightness(mapped_colour(map, a)), brightness(mapped_colour(map, b)));
    }
    const double left = brightness(mapped_colour(ColourMap::blue_white_red, a));
    const double right = brightness(mapped_colour(ColourMap::blue_white_red, b));
    EXPECT_EQ(left < right, b <= 0.5) << a;
  }
}

TEST(ColourScale, SharesAndValuesAreInverse) {
  for (const bool root : {false, true}) {
    const ColourScale scale{ColourMap::viridis, {-2, 6}, root};
    for (double value = -2; value <= 6; value += 0.5) {
      EXPECT_NEAR(scale.value(scale.share(value)), value, 1e-12);
    }
    EXPECT_EQ(scale.share(-3), 0);
    EXPECT_EQ(scale.share(7), 1);
    EXPECT_EQ(scale.share(0), root ? 0.5 : 0.25);
  }
  EXPECT_EQ((ColourScale{ColourMap::viridis, {3, 3}}.share(3)), 0.5);
}

TEST(ColourScale, RoundRangesHoldTheirValues) {
  EXPECT_EQ(round_range(4.3, 37.9), (ColourRange{0, 40}));
  EXPECT_EQ(round_range(-2.5, 61), (ColourRange{-20, 80}));
  EXPECT_EQ(round_range(0, 0), (ColourRange{0, 1}));
  EXPECT_EQ(round_range(0, 100), (ColourRange{0, 100})) << "already round";
  EXPECT_EQ(round_range(0.9, 6.6), (ColourRange{0, 8})) << "five steps, of 2";
  for (const double value : {-7.0, 0.003, 12.5, 1e6}) {
    const ColourRange range = round_range(value, value);
    EXPECT_NEAR((range.low + range.high) / 2, value, 1e-9 * std::fabs(value));
    EXPECT_LT(range.low, range.high);
  }
  for (double low = -3; low < 3; low += 0.37) {
    for (double span = 1e-4; span < 1e4; span *= 3.1) {
      const ColourRange range = round_range(low, low + span);
      EXPECT_LE(range.low, low + 1e-6 * span);
      EXPECT_GE(range.high, low + span - 1e-6 * span);
      EXPECT_LE(range.high - range.low, 3 * span);
    }
  }
}

}  // namespace
}  // namespace alphascope
