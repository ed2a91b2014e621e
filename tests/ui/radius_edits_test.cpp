#include "ui/panels/radius_edits.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

const AtomGroup kIron{"HEM", "FE", "Fe"};

TEST(RadiusEdits, OneRadiusForEachGroup) {
  RadiusEdits edits;
  EXPECT_TRUE(edits.set(kIron, 1.5));
  EXPECT_TRUE(edits.set(kIron, 1.6));
  EXPECT_TRUE(edits.set({"HEM", "NA", "N"}, 1.7));
  ASSERT_EQ(edits.list().size(), 2u);
  EXPECT_DOUBLE_EQ(edits.find(kIron)->radius, 1.6);
  edits.reset(kIron);
  EXPECT_EQ(edits.find(kIron), nullptr);
  edits.reset_all();
  EXPECT_TRUE(edits.list().empty());
}

TEST(RadiusEdits, NeverZeroNegativeOrNotANumber) {
  RadiusEdits edits;
  edits.set(kIron, 1.5);
  for (const double bad : {0.0, -1.0, 60.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(edits.set(kIron, bad));
  }
  EXPECT_DOUBLE_EQ(edits.find(kIron)->radius, 1.5);
}

TEST(RadiusEdits, KeepsSixDecimals) {
  RadiusEdits edits;
  edits.set(kIron, 1.23456789);
  EXPECT_DOUBLE_EQ(edits.find(kIron)->radius, 1.234568);
}

}  // namespace
}  // namespace alphascope
