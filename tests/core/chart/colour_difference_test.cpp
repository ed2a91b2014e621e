// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that colours of chains and cavities can be told apart, also by colour-blind people. Units
// are those of CIEDE2000, where about 1 is the least visible difference side by side.
#include "tests/support/colour_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/chart/colour_map.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope::testing {
namespace {

std::vector<Rgb8> chains(std::size_t count = kChainColours) {
  std::vector<Rgb8> colours;
  for (std::size_t n = 0; n < count; ++n) colours.push_back(chain_colour(n));
  return colours;
}

std::vector<Rgb8> cavities() {
  std::vector<Rgb8> colours;
  for (std::size_t n = 0; n < kCavityColours; ++n) colours.push_back(cavity_colour(n));
  return colours;
}

template <class Difference>
double least_of_pairs(const std::vector<Rgb8>& colours, const Difference& difference) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      least = std::min(least, difference(colours[i], colours[k]));
    }
  }
  return least;
}

double usual(const Rgb8& a, const Rgb8& b) {
  return difference(a, b, ViewFrustum::usual);
}

// From the table of Sharma, Wu and Dalal.
TEST(ColourDifference, IsCiede2000) {
  EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(ciede2000({50, -1.3802, -84.2814}, {50, 0, -82.7485}), 1.0, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.49, -0.001}, {50, -2.49, 0.0011}), 7.2195, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {58, 24, 15}), 19.4535, 1e-4);
}

TEST(ColourDifference, WhatEyesConfuseIsAlike) {
  for (const ViewFrustum sight : kSights) {
    const LabColour grey = seen({128, 128, 128}, sight);
    EXPECT_NEAR(grey.lightness, 53.585, 0.01);
    EXPECT_NEAR(std::hypot(grey.a, grey.b), 0, 0.05);
  }
  const Rgb8 red{200, 80, 60}, green{110, 125, 50};
  EXPECT_GT(usual(red, green), 40);
  EXPECT_LT(difference(red, green, ViewFrustum::deuteranopia), usual(red, green) / 2);
}

TEST(ChainColours, DifferForEveryEyeTheFirstOnesMost) {
  EXPECT_GE(least_of_pairs(chains(), least_difference), 8);
  EXPECT_GE(least_of_pairs(chains(12), least_difference), 11);
  EXPECT_GE(least_of_pairs(chains(8), least_difference), 13);
  EXPECT_GE(least_of_pairs(chains(), usual), 11);
  EXPECT_GE(least_of_pairs(chains(12), usual), 17);
  EXPECT_GE(least_of_pairs(chains(8), usual), 19);
}

// Every eye sees differences in lightness, and a grey print keeps them.
TEST(ChainColours, NeighboursDifferInLightness) {
  for (std::size_t n = 0; n < kChainColours; ++n) {
    const double one = seen(chain_colour(n), ViewFrustum::usual).lightness;
    const double next = seen(chain_colour(n + 1), ViewFrustum::usual).lightness;
    EXPECT_GE(std::fabs(one - next), 9) << n;
    EXPECT_GE(one, 35) << n << ": it is lost on the dark background";
    EXPECT_LE(one, 88) << n << ": it is lost on the light one";
  }
  EXPECT_EQ(chain_colour(kChainColours), chain_colour(0));
}

TEST(CavityColours, AreThoseOfNoChain) {
  for (const Rgb8& cavity : cavities()) {
    for (const Rgb8& chain : chains()) {
      EXPECT_GE(usual(cavity, chain), 13.5);
      EXPECT_GE(least_difference(cavity, chain), 6);
    }
  }
  EXPECT_GE(least_of_pairs(cavities(), least_difference), 9);
  EXPECT_GE(least_of_pairs(cavities(), usual), 16);
  EXPECT_EQ(cavity_colour(kCavityColours), cavity_colour(0));
}

}  // namespace
}  // namespace alphascope::testing
