// SPDX-License-Identifier: GPL-3.0-or-later
// Tests backgrounds, sizes in print, and presets for a use of pictures.
#include "core/document/picture/picture_preset.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/document/picture/picture_options.hpp"
#include "core/document/settings/display.hpp"

namespace alphascope {
namespace {

TEST(PictureBackgrounds, AreReadAsTheyAreWritten) {
  for (const char* text : {"theme", "white", "black", "transparent", "#f4f0e0"}) {
    const auto background = read_background(text);
    ASSERT_TRUE(background) << text;
    EXPECT_EQ(background_text(*background), text);
  }
  EXPECT_EQ(read_background("#fff"), kWhiteBackground);
  for (const char* text : {"", "grey", "#12345", "white "}) {
    EXPECT_FALSE(read_background(text)) << text;
  }
}

TEST(PictureBackgrounds, AreLightWhereDarkLettersAreReadable) {
  EXPECT_TRUE(is_light({255, 255, 255}));
  EXPECT_TRUE(is_light({255, 255, 0}));
  EXPECT_FALSE(is_light({0, 0, 255}));
  EXPECT_FALSE(is_light({0, 0, 0}));
}

TEST(PictureSizes, AreTheNearestPixels) {
  EXPECT_EQ(pixels_of(85, 300), 1004);
  EXPECT_EQ(pixels_of(25.4, 600), 600);
  EXPECT_NEAR(millimetres(1004, 300), 85, 0.05);
}

TEST(PicturePresets, ForAUseKeepWhatIsDrawn) {
  DisplaySettings user;
  user.balls = false;
  user.triangles = true;
  user.complex_opacity = 0.5f;
  user.ball_paint.by = ColourBy::chain;
  PictureOptions options;
  options.scale_bar = true;
  options.legend = false;
  std::set<std::string> ids;
  for (const DisplayPreset preset : kDisplayPresets) {
    EXPECT_TRUE(ids.insert(preset_info(preset).id).second);
    EXPECT_EQ(preset_named(preset_info(preset).id), preset);
    const PictureOptions set = with_preset(options, preset);
    if (!is_for_use(preset)) {
      EXPECT_EQ(set, options) << "a look says nothing about files";
      continue;
    }
    EXPECT_TRUE(set.scale_bar);
    EXPECT_FALSE(set.legend);
    DisplaySettings display = with_preset(user, preset);
    for (auto member : {&DisplaySettings::outlines, &DisplaySettings::face_lines,
                        &DisplaySettings::depth_cue, &DisplaySettings::shadow_strength}) {
      display.*member = user.*member;
    }
    EXPECT_EQ(display, user) << "all but light and lines stays";
  }
}

TEST(PicturePresets, OfAPublicationFitOneColumn) {
  const PictureOptions paper = with_preset(PictureOptions(), DisplayPreset::publication);
  EXPECT_EQ(paper.background, kWhiteBackground);
  EXPECT_EQ(paper.dpi, 300);
  EXPECT_NEAR(millimetres(paper.width, paper.dpi), 85, 0.1);
  EXPECT_EQ(with_preset(DisplaySettings(), DisplayPreset::publication).depth_cue, 0);
  EXPECT_GT(with_preset(PictureOptions(), DisplayPreset::projector).letters, 1);
  EXPECT_FALSE(
      is_light(*with_preset(PictureOptions(), DisplayPreset::projector).background.colour));
}

}  // namespace
}  // namespace alphascope
