// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the choice of a picture's quality by the times of earlier ones.
#include "ui/scene/quality.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

TEST(QualityChooser, StartsWithADraft) {
  const QualityChooser chooser;
  EXPECT_EQ(chooser.moving(), RenderQuality::draft);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft);
}

TEST(QualityChooser, AFastMachineDrawsShadowsAlways) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 2);
  EXPECT_EQ(chooser.moving(), RenderQuality::medium);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::fine);
}

TEST(QualityChooser, ASlowOneDraftsWhileMovingAndRefinesAtRest) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 40);
  EXPECT_EQ(chooser.moving(), RenderQuality::draft);
  EXPECT_EQ(chooser.while_computing(), RenderQuality::sketch);
  chooser.note(RenderQuality::draft, 60);
  EXPECT_EQ(chooser.moving(), RenderQuality::sketch);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::fine);
  chooser.note(RenderQuality::fine, 2000);  // worse than expected
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft) << "a sample would hold up the next input";
}

TEST(QualityChooser, ExpectsASampleByWhatItKnows) {
  QualityChooser chooser;
  chooser.note(RenderQuality::draft, 1400);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::draft) << "at rest all pixels are drawn";
  chooser.forget();
  chooser.note(RenderQuality::draft, 10);
  EXPECT_EQ(chooser.at_rest(), RenderQuality::fine);
  chooser.note(RenderQuality::fine, 31);
  EXPECT_EQ(chooser.sample(), 31);
}

}  // namespace
}  // namespace alphascope
