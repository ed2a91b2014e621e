// SPDX-License-Identifier: GPL-3.0-or-later
// Tests edits of radii by hand.
#include "core/document/settings/radius_edits.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace alphascope {
namespace {

const AtomGroup kIron{"HEM", "FE", 26};

TEST(RadiusEdits, OneRadiusForEachGroup) {
  RadiusEdits edits;
  EXPECT_TRUE(set_radius(edits, kIron, 1.5));
  EXPECT_TRUE(set_radius(edits, kIron, 1.6));
  EXPECT_TRUE(set_radius(edits, {"HEM", "NA", 7}, 1.7));
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_EQ(find_radius(edits, kIron)->microangstrom, 1'600'000);
  reset_radius(edits, kIron);
  EXPECT_EQ(find_radius(edits, kIron), nullptr);
  EXPECT_EQ(edits.size(), 1u);
}

TEST(RadiusEdits, NeverZeroNegativeOrNotANumber) {
  RadiusEdits edits;
  set_radius(edits, kIron, 1.5);
  for (const double bad : {0.0, -1.0, 60.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(set_radius(edits, kIron, bad));
  }
  EXPECT_EQ(find_radius(edits, kIron)->microangstrom, 1'500'000);
}

TEST(RadiusEdits, KeepsSixDecimals) {
  RadiusEdits edits;
  set_radius(edits, kIron, 1.23456789);
  EXPECT_EQ(find_radius(edits, kIron)->microangstrom, 1'234'568);
}

}  // namespace
}  // namespace alphascope
