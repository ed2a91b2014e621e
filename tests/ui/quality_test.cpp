#include "ui/scene/quality.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

TEST(QualityChooser, StartsWithADraft) {
  const QualityChooser chooser;
  EXPECT_EQ(chooser.moving(), RenderQuality::draft);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft);
}

TEST(QualityChooser, AFastMachineDrawsFineAlways) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 2);
  EXPECT_EQ(chooser.moving(), RenderQuality::fine);
}

TEST(QualityChooser, ASlowOneDraftsWhileMovingAndRefinesAtRest) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 40);
  EXPECT_EQ(chooser.moving(), RenderQuality::draft);
  EXPECT_EQ(chooser.while_computing(), RenderQuality::sketch);
  chooser.note(RenderQuality::draft, 60);
  EXPECT_EQ(chooser.moving(), RenderQuality::sketch);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::fine);
  chooser.note(RenderQuality::fine, 1500);  // worse than expected
  EXPECT_EQ(chooser.at_rest(), RenderQuality::medium);
}

TEST(QualityChooser, NeverExceedsTheBudgetByExpectation) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 400);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft);
  chooser.note(RenderQuality::draft, 1400);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft) << "at rest all pixels are drawn";
  chooser.forget();
  chooser.note(RenderQuality::draft, 10);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::fine);
}

}  // namespace
}  // namespace alphascope
