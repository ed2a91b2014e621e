// SPDX-License-Identifier: GPL-3.0-or-later
// Tests typed numbers in the window and on the command line: no digit is dropped, and bounds hold.
#include "core/document/commands/number_input.hpp"

#include <gtest/gtest.h>

#include "app/viewer/options.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"
#include "tests/ui/panels/panels_fixture.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

using testing::loaded_state;
using testing::Panels;

TEST(NumberInput, ReadsWhatPeopleType) {
  const std::pair<const char*, double> good[] = {
      {"1.4", 1.4}, {"1,4", 1.4}, {" 1.4 Å ", 1.4}, {"1.4 A", 1.4}, {"1.4Å", 1.4},
      {"+2", 2},    {"2e1", 20},  {".5", 0.5},      {"5.", 5},      {"1e-400", 0},
  };
  for (const auto& [text, value] : good) {
    const NumberInput input = read_number(text, kSolventRule);
    ASSERT_TRUE(input.value) << text << ": " << input.error;
    EXPECT_DOUBLE_EQ(*input.value, value) << text;
  }
  EXPECT_EQ(read_number("−3,5 Å²", kAlphaRule).value, -3.5);
  EXPECT_EQ(read_number("-3.5 A^2", kAlphaRule).value, -3.5);
}

TEST(NumberInput, KeepsEveryDigitOfAlpha) {
  const AlphaInput typed = read_alpha(" −1,250001500000249999 Å²");
  ASSERT_TRUE(typed.value) << typed.error;
  EXPECT_EQ(shortest_number(*typed.value), "-1.250001500000249999");
  EXPECT_EQ(read_alpha("1.4").value, Alpha(1.4));
  EXPECT_NE(read_alpha("1e-19").error.find("more than 18 digits behind"), std::string::npos);
  EXPECT_NE(read_alpha("1000000000000000000000000.1").error.find("must lie between"),
            std::string::npos);
  EXPECT_NE(read_alpha("soon").error.find("is not a number"), std::string::npos);
  EXPECT_NE(read_alpha("").error.find("Write a number"), std::string::npos);
}

TEST(NumberInput, RefusesTheRestAndSaysWhatToDo) {
  for (const char* bad : {"", " ", "abc", "nan", "inf", "-inf", "1e", "e5", "1.4.2", "1,234.5",
                          "1 4", "1.4x", "0x10", "1.4 nm", "--1", "+-1", "1..", ",", "."}) {
    const NumberInput input = read_number(bad, kSolventRule);
    EXPECT_FALSE(input.value) << bad;
    EXPECT_NE(input.error.find("Write"), std::string::npos) << input.error;
  }
  for (const char* length : {"1.4 A", "1.4Å"}) {
    EXPECT_EQ(read_number(length, kAlphaRule).error,
              std::string("“") + length +
                  "” has another unit. Alpha is an area, in Å². Write a number such as 1.4 Å².");
  }
  constexpr NumberRule kVolume{"The volume", 0, 1e9, "Å³"};
  EXPECT_EQ(read_number("30 A3", kVolume).value, 30);
  EXPECT_EQ(read_number("30 Å^3", kVolume).value, 30);
  EXPECT_NE(read_number("30 Å²", kVolume).error.find("is a volume, in Å³."), std::string::npos);
  EXPECT_NE(read_number("30 Å3", kAlphaRule).error.find("is an area, in Å²."), std::string::npos);
  EXPECT_NE(read_number("1.4 Å²", kSolventRule).error.find("is a length, in Å."),
            std::string::npos);
  for (const char* beyond : {"-0.1", "101", "1e308", "1e999", "-1e999"}) {
    EXPECT_EQ(
        read_number(beyond, kSolventRule).error,
        std::string("The solvent radius must lie between 0 and 100 Å; “") + beyond + "” does not.");
  }
  EXPECT_FALSE(read_number("19.5", kPictureSizeRule).value);
  EXPECT_FALSE(read_number("1,920", kPictureSizeRule).value) << "not 1, not 1920";
}

TEST(NumberInput, AlphaHasTheBoundsOfTheProgram) {
  EXPECT_EQ(read_number(shortest_number(kMaxAlphaAngstrom2), kAlphaRule).value, kMaxAlphaAngstrom2);
  for (const char* beyond : {"1e308", "-1e308", "1e25", "1e999"}) {
    EXPECT_EQ(read_number(beyond, kAlphaRule).error,
              std::string("Alpha must lie between −10²⁴ and 10²⁴ Å²; “") + beyond + "” does not.");
  }
}

TEST(NumberInput, TextsAreReadBackAsTheSameNumber) {
  for (const double value : {1.4, -0.1, 1.2345678901234567, 1e24, 0.0, 1e-7}) {
    EXPECT_EQ(read_number(shortest_number(value), kAlphaRule).value, value);
  }
}

TEST(NumberInput, LargeNumbersAreShownShort) {
  EXPECT_EQ(short_number_text(1e24, 3), "10²⁴");
  EXPECT_EQ(number_text(1.25e12, 2), "1.25·10¹²");
  EXPECT_EQ(short_number_text(999999999, 2), "999999999");
}

TEST(NumberInput, TheCommandLineReadsTheSame) {
  const auto parse = [](std::initializer_list<const char*> arguments) {
    std::vector<const char*> argv{"alphascope"};
    argv.insert(argv.end(), arguments);
    return parse_options(static_cast<int>(argv.size()), argv.data());
  };
  EXPECT_DOUBLE_EQ(parse({"--alpha", "1,4"}).options.alpha, 1.4);
  EXPECT_DOUBLE_EQ(parse({"--alpha=-1e24"}).options.alpha, -1e24);
  for (const char* bad : {"--alpha=1e308", "--alpha=nan", "--alpha=1.4x", "--alpha=", "--scale=9",
                          "--solvent=-1", "--solvent=1e3"}) {
    const ParsedOptions parsed = parse({bad});
    ASSERT_TRUE(parsed.exit_code) << bad;
    EXPECT_NE(*parsed.exit_code, 0) << bad;
    EXPECT_FALSE(parsed.text.empty());
  }
}

// --- the fields

class NumberFields : public ::testing::Test {
 protected:
  NumberFields() {
    p.state = loaded_state();
    p.frame(3);
  }
  void control_click(const std::string& name) {
    p.point_at(name);
    ImGui::GetIO().KeyCtrl = true;
    p.press(true);
    p.press(false);
    ImGui::GetIO().KeyCtrl = false;
    p.frame(2);
  }
  void enter(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    p.frame(2);
    p.tap(key::kEnter);
    p.frame(2);
  }
  Panels p{{1280, 800, 1}};
};

TEST_F(NumberFields, ADecimalCommaIsOne) {
  p.type("alpha.typed", "1,4");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.4);
}

TEST_F(NumberFields, WhatIsNoNumberChangesNothingAndIsExplained) {
  p.state.settings.request.alpha_angstrom2 = 3;
  for (const char* bad : {"1e308", "abc", "1.4.2", "nan", "1e", " "}) {
    p.type("alpha.typed", bad);
    p.frame(2);
    EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3) << bad;
    EXPECT_TRUE(p.rects.contains("alpha.typed.error")) << bad;
  }
  // The text stays for correction.
  p.type("alpha.typed", "2.5x");
  p.click("alpha.typed");
  ImGui::GetIO().KeyCtrl = false;
  EXPECT_EQ(p.state.number.text, "2.5x");
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("alpha.typed.error"));
  p.type("alpha.typed", "2.5x");
  p.frame(2);
  EXPECT_TRUE(p.rects.contains("alpha.typed.error"));
  p.click("view");
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("alpha.typed.error")) << "it is given up";
  p.type("alpha.typed", "2.5x");
  p.tap(key::kEscape);
  p.frame(2);
  EXPECT_FALSE(p.rects.contains("alpha.typed.error"));
  p.type("alpha.typed", "2.5x");
  p.state.settings.request.alpha_angstrom2 = 4;
  p.frame(2);
  EXPECT_TRUE(p.state.number.refused.empty()) << "it has a value again";
  p.state.settings.request.alpha_angstrom2 = 3;
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 3);
}

TEST_F(NumberFields, SlidersAreTypedIntoWithTheSameBounds) {
  control_click("alpha.slider");
  enter("1,25");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.25);
  control_click("alpha.slider");
  enter("1e307");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1.25);
  EXPECT_TRUE(p.rects.contains("alpha.slider.error"));
  p.click("view");
  control_click("alpha.slider");
  enter("1e24");
  EXPECT_DOUBLE_EQ(p.state.settings.request.alpha_angstrom2, 1e24);
  p.frame(3);
  p.tap(key::kRight);
  EXPECT_LE(p.state.settings.request.alpha_angstrom2, kMaxAlphaAngstrom2);
  control_click("alpha.solvent");
  enter("1,375");
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.375);
  control_click("alpha.solvent");
  enter("1e9");
  EXPECT_DOUBLE_EQ(p.state.settings.request.solvent_radius_angstrom, 1.375);
}

TEST_F(NumberFields, SliderClicksWithoutControlStillSlide) {
  p.click("alpha.slider", 0.9f);
  EXPECT_GT(p.state.settings.request.alpha_angstrom2, 7);
  EXPECT_TRUE(p.state.number.name.empty());
}

TEST_F(NumberFields, PictureSizesAreWholeAndBounded) {
  p.state.dialogs.show_save = true;
  p.frame(3);
  p.click("save.width");
  ImGui::GetIO().AddInputCharactersUTF8("800");
  p.frame(2);
  p.tap(key::kTab);
  p.frame(2);
  EXPECT_EQ(p.state.window.picture.width, 800);
  for (const char* bad : {"0", "99999", "1,920", "12.5", "1e308"}) {
    p.type("save.width", bad);
    EXPECT_EQ(p.state.window.picture.width, 800) << bad;
    EXPECT_TRUE(p.state.dialogs.show_save) << bad;
  }
}

// A dialog keeps a wrong number, whatever the user clicks next. It must not do its work with the
// old number.
TEST_F(NumberFields, AWrongNumberKeepsADialogFromItsWork) {
  p.state.dialogs.show_save = true;
  p.frame(3);
  const auto refused = [&] { return p.state.number.refused.contains("save.width"); };
  const auto type_only = [&](const char* text) {
    p.click("save.width");
    ImGui::GetIO().AddInputCharactersUTF8(text);
    p.frame(2);
  };
  type_only("99999");
  p.click("save.ok");
  p.frame(2);
  EXPECT_FALSE(p.asked.screenshot) << "not of another size";
  EXPECT_TRUE(p.state.dialogs.show_save);
  EXPECT_TRUE(p.rects.contains("save.width.error"));
  p.click("save.ok");
  p.frame(2);
  EXPECT_FALSE(p.asked.screenshot);
  EXPECT_TRUE(refused());
  p.click("save.hd");
  p.frame(2);
  EXPECT_FALSE(refused()) << "it has a size again";
  type_only("99999");
  p.tap(key::kTab);
  p.frame(2);
  EXPECT_TRUE(refused()) << "the next field has the focus";
  EXPECT_TRUE(p.rects.contains("save.width.error"));
  type_only("640");
  p.click("save.ok");
  p.frame(2);
  ASSERT_TRUE(p.asked.screenshot);
  EXPECT_EQ(p.asked.screenshot->options.width, 640);
}

}  // namespace
}  // namespace alphascope
