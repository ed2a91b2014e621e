// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the table of the settings of the display: every row can be used wherever it appears.
#include "core/document/settings/display_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

#include "core/document/picture/picture_preset.hpp"
#include "core/document/settings/display_help.hpp"

namespace alphascope {
namespace {

TEST(DisplayFields, NamesAreUnique) {
  std::set<std::string> ids, keys, commands, options, former;
  ASSERT_EQ(display_fields().size(), 26u);
  for (const DisplayField& field : display_fields()) {
    EXPECT_TRUE(ids.insert(field.id).second) << field.id;
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(commands.insert(field.command).second) << field.command;
    const std::string option = field.option.name;
    EXPECT_TRUE(option.empty() || options.insert(option).second) << option;
    const std::string old = field.former_key;
    EXPECT_TRUE(old.empty() || former.insert(old).second) << old;
    EXPECT_EQ(&display_field(field.member), &field) << field.id;
  }
  EXPECT_EQ(former, (std::set<std::string>{"silhouettes_pixels", "face_edges_pixels"}));
  for (const std::string& old : former) EXPECT_FALSE(keys.contains(old)) << old;
}

TEST(DisplayFields, DefaultsAreWithinTheirBoundsAndOnAStep) {
  int numbers = 0;
  for (const DisplayField& field : display_fields()) {
    if (!is_number(field)) continue;
    ++numbers;
    const double usual = number_of(field, DisplaySettings());
    EXPECT_GE(usual, field.rule.least) << field.id;
    EXPECT_LE(usual, field.rule.most) << field.id;
    ASSERT_GT(field.step, 0) << field.id;
    EXPECT_NEAR(usual / field.step, std::round(usual / field.step), 1e-5) << field.id;
    EXPECT_LE(field.slider_most, field.rule.most) << field.id;
  }
  EXPECT_EQ(numbers, 13);
}

TEST(DisplayFields, ValuesAreSetAndRead) {
  DisplaySettings d;
  set_number(display_field(&DisplaySettings::balls), d, 0);
  EXPECT_FALSE(d.balls);
  set_number(display_field(&DisplaySettings::samples), d, 3.6);
  EXPECT_EQ(d.samples, 4);
  const DisplayField& thickness = display_field(&DisplaySettings::edge_thickness);
  set_number(thickness, d, 0.3);
  EXPECT_EQ(d.edge_thickness, 0.3f);
  EXPECT_EQ(number_of(thickness, d), static_cast<double>(0.3f));
  EXPECT_EQ(value_text(thickness, d), "0.3");
  EXPECT_EQ(range_text(thickness), "0.02 to 1");
  EXPECT_EQ(value_text(display_field(&DisplaySettings::balls), d), "off");
  EXPECT_EQ(value_text(display_field(&DisplaySettings::ball_paint), d), "chain");
  EXPECT_EQ(value_text(display_field(&DisplaySettings::samples), d), "4");
  const DisplayField& paint = display_field(&DisplaySettings::ball_paint);
  EXPECT_THROW(number_of(paint, d), std::logic_error);
  EXPECT_THROW(set_number(paint, d, 1), std::logic_error);
}

TEST(DisplayFields, ADifferenceHasTheNameOfItsSetting) {
  const DisplaySettings a;
  EXPECT_EQ(difference_of(a, a), "");
  DisplaySettings b;
  b.edge_thickness = 0.5f;
  EXPECT_EQ(difference_of(a, b), "thickness of edges");
  b.samples = 1;
  EXPECT_EQ(difference_of(a, b), "display");
  b = a;
  b.beside.waters = true;
  EXPECT_EQ(difference_of(a, b), "atoms beside the body");
  b = a;
  b.complex_paint.by = ColourBy::alpha;
  EXPECT_EQ(difference_of(a, b), "colours of simplices");
}

TEST(DisplayFields, TheHelpHasALineForEach) {
  const std::string help = display_help();
  EXPECT_EQ(static_cast<std::size_t>(std::count(help.begin(), help.end(), '\n')),
            1 + display_fields().size() + std::size(kBesideKinds));
  EXPECT_NE(help.find("\n  Thickness of edges "), std::string::npos) << help;
  EXPECT_NE(help.find("  0.02 to 1 Å  "), std::string::npos) << help;
  EXPECT_NE(help.find("  --beside  "), std::string::npos) << help;
  EXPECT_NE(help.find("  edge_thickness_angstrom\n"), std::string::npos) << help;
}

// A group is copied whole, and nothing else.
TEST(DisplayFields, GroupsAreCopied) {
  DisplaySettings from;
  from.ambient_occlusion = false;
  from.shadow_strength = 0.5f;
  from.depth_cue = 0.9f;
  from.outlines = 3;
  from.face_lines = 2;
  from.samples = 2;
  from.balls = false;
  from.orthographic = true;
  DisplaySettings to;
  copy_group(DisplayGroup::light, from, to);
  DisplaySettings expected = from;
  expected.balls = true;
  expected.orthographic = false;
  EXPECT_EQ(to, expected);
}

TEST(DisplayFields, PresetsKeepColoursAndProjection) {
  DisplaySettings user;
  user.ball_paint.by = ColourBy::element;
  user.complex_paint.by = ColourBy::alpha;
  user.orthographic = user.grown_balls = true;
  user.cavity_opacity = 0.9f;
  user.beside.ions = false;
  user.ball_opacity = 0.4f;
  for (const DisplayPreset preset : kDisplayPresets) {
    const DisplaySettings d = with_preset(user, preset);
    EXPECT_EQ(d.ball_paint, user.ball_paint);
    EXPECT_EQ(d.complex_paint, user.complex_paint);
    EXPECT_TRUE(d.orthographic && d.grown_balls);
    EXPECT_EQ(d.cavity_opacity, 0.9f);
    EXPECT_EQ(d.beside, user.beside);
    EXPECT_EQ(d.ball_opacity, is_for_use(preset) ? user.ball_opacity : 1);
  }
}

}  // namespace
}  // namespace alphascope
