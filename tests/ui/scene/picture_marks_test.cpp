// SPDX-License-Identifier: GPL-3.0-or-later
// Tests legend and scale bar: their layout in the window, and their drawing in saved pictures.
#include "ui/picture_marks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "core/geometry/lattice_alpha.hpp"
#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/scene/picture_difference.hpp"
#include "tests/ui/scene/png_pixels.hpp"
#include "tests/ui/scene/rod_picture.hpp"
#include "ui/colour_legend.hpp"
#include "ui/scene/picture/draw_marks.hpp"
#include "ui/scene/picture/mark_mask.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope::testing {
namespace {

constexpr float kLine = 14;

MarkFont type_of(float unit) {
  return {unit, kLine * unit,
          [unit](const std::string& text) { return 7 * unit * static_cast<float>(text.size()); }};
}

ColourLegend legend_from(double low, double high) {
  ColourLegend legend{"alpha value (Å²), square-root scale", {}};
  for (int i = 0; i <= 8; ++i) {
    const double share = i / 8.0;
    legend.stops.push_back({{static_cast<float>(share), 0.5f, 0.25f}, low + share * (high - low)});
  }
  return legend;
}

bool same_colour(const std::uint8_t* pixel, const Colour& c, int tolerance) {
  const float wanted[3] = {c.r, c.g, c.b};
  for (int k = 0; k < 3; ++k) {
    if (std::abs(pixel[k] - static_cast<int>(std::lround(wanted[k] * 255))) > tolerance) {
      return false;
    }
  }
  return true;
}

Colour from_byte(const Rgb8& c) {
  return {c.r / 255.0f, c.g / 255.0f, c.b / 255.0f};
}

// Counts rows that show the whole scale, first to last colour, at the legend's bar.
int rows_with_scale(const Image& image, const AlphaScale& scale) {
  const float unit = mark_unit(image.width, image.height);
  const int left = static_cast<int>(std::lround(20 * unit));
  const int right = static_cast<int>(std::lround(200 * unit));
  int rows = 0;
  for (int y = 0; y < image.height && right < image.width; ++y) {
    bool all = true;
    for (int x = left; x < right && all; ++x) {
      const double share = (x - left + 0.5) / (right - left);
      all = same_colour(&image.rgba[4 * (std::size_t(y) * image.width + x)],
                        from_byte(scale.colour_at(share)), 4);
    }
    rows += all;
  }
  return rows;
}

struct PixelRun {
  int x = 0, y = 0, length = 0;
};

// The longest row of pixels in one colour.
PixelRun longest_run(const Image& image, const Colour& colour) {
  PixelRun longest;
  for (int y = 0; y < image.height; ++y) {
    int start = 0;
    for (int x = 0; x <= image.width; ++x) {
      const bool on = x < image.width &&
                      same_colour(&image.rgba[4 * (std::size_t(y) * image.width + x)], colour, 2);
      if (on) continue;
      if (x - start > longest.length) longest = {start, y, x - start};
      start = x + 1;
    }
  }
  return longest;
}

Image plain(int width, int height, const Colour& colour, std::uint8_t alpha = 255) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    for (const float c : {colour.r, colour.g, colour.b}) {
      image.rgba.push_back(static_cast<std::uint8_t>(std::lround(c * 255)));
    }
    image.rgba.push_back(alpha);
  }
  return image;
}

TEST(PictureMarks, TheLegendSaysQuantityUnitAndTheEndsOfItsScale) {
  const auto layout = lay_out_legend(legend_from(-1.25, 3.4), 960, 500, type_of(1));
  ASSERT_TRUE(layout);
  ASSERT_EQ(layout->texts.size(), 6u);
  EXPECT_EQ(layout->texts[0].text, "alpha value (Å²), square-root scale");
  const MarkBox& bar = layout->bar.value();
  for (int i = 0; i < 5; ++i) {  // round numbers, each at its place
    const MarkText& number = layout->texts[1 + i];
    EXPECT_EQ(number.text, (std::array<std::string, 5>{"−1", "0", "1", "2", "3"}[i]));
    const float place = bar.x0 + 180 * (static_cast<float>(i) + 0.25f) / 4.65f;
    const float middle = number.x + type_of(1).text_width(number.text) / 2;
    EXPECT_NEAR(middle, place, 0.01) << i;
    EXPECT_NEAR(layout->ticks[i].x0, place - 0.5, 0.01);
  }
  EXPECT_LE(layout->whole.y1, 500);
  EXPECT_FALSE(lay_out_legend(legend_from(0, 1), 419, 500, type_of(1)));
  EXPECT_FALSE(lay_out_legend(legend_from(0, 1), 960, 500, type_of(3)));
  EXPECT_FALSE(lay_out_legend({}, 960, 500, type_of(1)));
}

TEST(PictureMarks, DifferentColoursHaveDifferentNumbers) {
  const auto layout = lay_out_legend(legend_from(1.4, 1.401), 960, 500, type_of(1));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->texts[1].text, "1.4");
  EXPECT_EQ(layout->texts[2].text, "1.4005");
  EXPECT_EQ(layout->texts[3].text, "1.401");
  const MarkBox& bar = layout->bar.value();
  EXPECT_GE(layout->texts[1].x, bar.x0 - 10) << "outer ones stay within the margin";
  EXPECT_NEAR(layout->texts[3].x + type_of(1).text_width("1.401"), bar.x1 + 10, 1e-3);
}

// For any range there are at least two numbers, apart from each other, rising and within the bar.
TEST(PictureMarks, NumbersOfALegendStandApart) {
  for (double low = -50; low < 60; low += 7.31) {
    for (double span = 1e-3; span < 1e5; span *= 2.7) {
      const auto layout = lay_out_legend(legend_from(low, low + span), 960, 500, type_of(1));
      ASSERT_TRUE(layout);
      ASSERT_GE(layout->texts.size(), 3u);
      for (std::size_t i = 1; i < layout->texts.size(); ++i) {
        const MarkText& text = layout->texts[i];
        EXPECT_GE(text.x, layout->bar->x0 - 10);
        EXPECT_LE(text.x + type_of(1).text_width(text.text), layout->bar->x1 + 10.01);
        if (i == 1) continue;
        const MarkText& before = layout->texts[i - 1];
        EXPECT_GT(text.x, before.x + type_of(1).text_width(before.text));
        EXPECT_NE(text.text, before.text);
      }
    }
  }
}

ColourLegend names_of(std::size_t count) {
  ColourLegend legend{"chain", {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    legend.entries.push_back({{0, 1, 0}, "chain " + std::to_string(i)});
  }
  return legend;
}

TEST(PictureMarks, CategoriesAreListedAndCountedWhereThereIsNoRoom) {
  const auto few = lay_out_legend(names_of(3), 960, 500, type_of(1));
  ASSERT_TRUE(few);
  EXPECT_EQ(few->patches.size(), 3u);
  ASSERT_EQ(few->texts.size(), 4u);
  EXPECT_EQ(few->texts[3].text, "chain 2");
  EXPECT_FALSE(few->bar);
  const auto many = lay_out_legend(names_of(1234), 960, 500, type_of(1));
  ASSERT_TRUE(many);
  const std::size_t shown = many->patches.size();
  EXPECT_GT(shown, 3u);
  EXPECT_LT(shown, 30u);
  EXPECT_EQ(many->texts.back().text, "and 1," + std::to_string(234 - shown) + " more");
  for (std::size_t i = 0; i < shown; ++i) {
    const MarkBox& box = many->patches[i].box;
    EXPECT_LT(box.x1, many->texts[1 + i].x) << "before its name";
    EXPECT_GE(box.y0, many->whole.y0);
    EXPECT_LE(box.y1, many->whole.y1);
  }
  EXPECT_LE(many->whole.x1, 480) << "the other half is the scale bar's";
}

TEST(PictureMarks, TwoLegendsAreOneAboveTheOther) {
  ColourLegend quantity = legend_from(0, 60);
  quantity.entries.push_back({{0.5f, 0.5f, 0.5f}, "no B factor in the file"});
  const auto both = lay_out_legends({quantity, names_of(20)}, 960, 500, type_of(1));
  ASSERT_EQ(both.size(), 2u);
  EXPECT_LT(both[0].whole.y1, both[1].whole.y0);
  ASSERT_EQ(both[0].patches.size(), 1u);
  EXPECT_GT(both[0].patches[0].box.y0, both[0].bar->y1);
  EXPECT_EQ(lay_out_legends({quantity, names_of(20)}, 960, 100, type_of(1)).size(), 1u)
      << "no room for another";
}

TEST(PictureMarks, TheScaleBarIsARoundLengthAndAsLongAsItSays) {
  for (const float unit : {1.0f, 2.5f}) {
    for (double per_pixel = 1e-4; per_pixel < 1e4; per_pixel *= 1.17) {
      const auto bar = lay_out_scale_bar(per_pixel, 960 * unit, 600 * unit, type_of(unit));
      ASSERT_TRUE(bar);
      const double pixels = (bar->lines[2].x0 - bar->lines[1].x0);
      EXPECT_NEAR(pixels * per_pixel, bar->angstrom, 1e-3 * bar->angstrom);
      EXPECT_GE(pixels, 51.9 * unit);
      EXPECT_LE(pixels, 130.1 * unit);
      const double decade = std::pow(10, std::floor(std::log10(bar->angstrom * 1.0001)));
      const double digit = bar->angstrom / decade;
      EXPECT_NEAR(std::min({std::fabs(digit - 1), std::fabs(digit - 2), std::fabs(digit - 5)}), 0,
                  1e-9)
          << bar->angstrom;
    }
  }
  EXPECT_EQ(lay_out_scale_bar(0.1, 960, 600, type_of(1))->text.text, "10 Å");
  EXPECT_FALSE(lay_out_scale_bar(0, 960, 600, type_of(1)));
  EXPECT_FALSE(lay_out_scale_bar(0.1, 100, 600, type_of(1)));
}

TEST(PictureMarks, CaptionsFillLinesAndStayInTheirHalf) {
  const std::vector<std::string> words{std::string(40, 'a'), std::string(50, 'b'), "c"};
  const auto wide = lay_out_caption(words, 960, 600, type_of(1));  // room for 131 letters
  ASSERT_TRUE(wide);
  ASSERT_EQ(wide->lines.size(), 1u);
  EXPECT_EQ(wide->lines[0].text, words[0] + "   " + words[1] + "   c");
  const auto narrow = lay_out_caption(words, 480, 600, type_of(1));  // room for 62
  ASSERT_TRUE(narrow);
  ASSERT_EQ(narrow->lines.size(), 2u);
  EXPECT_EQ(narrow->lines[0].text, words[0]);
  EXPECT_EQ(narrow->lines[1].text, words[1] + "   c");
  EXPECT_GE(narrow->lines[1].y, narrow->lines[0].y + kLine);
  const auto cut = lay_out_caption(words, 240, 600, type_of(1));
  ASSERT_TRUE(cut);
  for (const MarkText& line : cut->lines) {
    EXPECT_LE(line.x + type_of(1).text_width(line.text), 240 - 20) << line.text;
  }
  EXPECT_NE(cut->lines[0].text.find("…"), std::string::npos);
  EXPECT_FALSE(lay_out_caption(words, 170, 600, type_of(1)));
  EXPECT_FALSE(lay_out_caption(words, 240, 100, type_of(1))) << "more than half of the height";
  EXPECT_FALSE(lay_out_caption({}, 960, 600, type_of(1)));
}

int inked(const MarkLetters& letters, const std::string& text) {
  int sum = 0;
  for (const std::uint8_t c : letters.mask({0, 0, text}).coverage) sum += c;
  return sum / 255;
}

// A missing letter is a box, the same for all letters of these planes.
TEST(PictureMarks, TheLettersKnowUnitsMinusSignsAndSuperscripts) {
  const MarkLetters letters(40);
  const std::string unknown = "\xf3\xb0\x80\x80";  // in the private use area
  ASSERT_GT(inked(letters, unknown), 0);
  for (const char* text : {"α", "Å", "²", "−", "⁻", "⁹", "…", "·", "×", "√", "ρ"}) {
    EXPECT_GT(inked(letters, text), 0) << text;
    EXPECT_NE(letters.mask({0, 0, text}).coverage, letters.mask({0, 0, unknown}).coverage) << text;
  }
  EXPECT_GT(letters.width("−"), 1.2f * letters.width("-")) << "a minus sign is no hyphen";
}

TEST(PictureMarks, LettersAreAsLargeAsTheyAreAskedToBe) {
  for (const float pixels : {9.8f, 14.0f, 50.4f}) {
    const MarkLetters letters(pixels);
    const MarkMask mask = letters.mask({0, 0, "H"});
    int rows = 0;
    for (int y = 0; y < mask.height; ++y) {
      int most = 0;
      for (int x = 0; x < mask.width; ++x) {
        most = std::max<int>(most, mask.coverage[std::size_t(y) * mask.width + x]);
      }
      rows += most > 127;
    }
    EXPECT_NEAR(rows, 0.727 * pixels, 1) << pixels;  // Inter's capitals
    EXPECT_NEAR(letters.width("HHHHHHHHHH"), 10 * letters.width("H"), 1e-3) << pixels;
  }
}

TEST(PictureMarks, RimsAreAsWideAsTheyAreAskedToBeAndRound) {
  const MarkMask dot = mask_of({10, 20, 11, 21});
  for (const int reach : {1, 2, 7}) {
    const MarkMask rim = rim_of(dot, reach);
    const int size = 2 * reach + 1;
    ASSERT_EQ(rim.x, 10 - reach);
    ASSERT_EQ(rim.width, size);
    ASSERT_EQ(rim.coverage.size(), std::size_t(size) * size);
    int covered = 0;
    for (const std::uint8_t c : rim.coverage) covered += c == 255;
    EXPECT_EQ(rim.coverage[std::size_t(reach) * size], 255) << "to the left";
    EXPECT_EQ(rim.coverage[reach], 255) << "upwards";
    EXPECT_EQ(rim.coverage[0], reach == 1 ? 255 : 0) << "the corner";
    EXPECT_NEAR(covered, M_PI * (reach + 0.5) * (reach + 0.5), 2) << reach;
  }
}

TEST(PictureMarks, NothingAskedForChangesNothing) {
  Image image = plain(640, 400, palette(Theme::dark).scene);
  const std::vector<std::uint8_t> before = image.rgba;
  EXPECT_EQ(draw_marks(image, {}, mark_colours(Theme::dark)), "");
  EXPECT_EQ(image.rgba, before);
}

TEST(PictureMarks, TextContrastsWithEveryBackground) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    for (const bool transparent : {false, true}) {
      const MarkColours ink = mark_colours(theme, {transparent, {}});
      const Colour background = transparent ? Colour{0, 0, 0, 0} : palette(theme).scene;
      Image image = plain(960, 600, background, transparent ? 0 : 255);
      draw_marks(image, {{legend_from(0, 1)}, 0.1}, ink);
      int marked = 0, rim = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const bool opaque = image.rgba[i + 3] == 255;
        marked += opaque && same_colour(&image.rgba[i], ink.mark, 2);
        rim += opaque && same_colour(&image.rgba[i], ink.rim, 2);
      }
      EXPECT_GT(marked, 280);  // the scale bar's lines alone are 200
      EXPECT_GT(rim, 1000);
      EXPECT_GT(std::fabs(ink.mark.g - ink.rim.g), 0.6);
      EXPECT_EQ(image.rgba[3], transparent ? 0 : 255) << "the rest stays as it was";
    }
  }
}

TEST(PictureMarks, TooSmallAPictureSaysSo) {
  Image image = plain(200, 150, palette(Theme::light).scene);
  const std::string said =
      draw_marks(image, {{legend_from(0, 1)}, 0.1}, mark_colours(Theme::light));
  EXPECT_NE(said.find("no legend, which takes 294 x 63 pixels"), std::string::npos) << said;
  EXPECT_EQ(said.find("no scale bar"), std::string::npos) << said;
  image = plain(294, 63, palette(Theme::light).scene);
  EXPECT_EQ(draw_marks(image, {{legend_from(0, 1)}, 0.1}, mark_colours(Theme::light)), "");
}

class SavedPicture : public ::testing::Test {
 protected:
  SavedPicture() {
    settings_.options.legend = true;
    settings_.display.ball_paint.by = ColourBy::single;  // has no meaning
    settings_.display.complex_paint.by = ColourBy::alpha;
  }
  Image save() {
    const auto path = std::filesystem::temp_directory_path() /
                      ("alphascope_marks_" + std::to_string(getpid()) + ".png");
    draw_carbons(balls_, complex_, settings_, path);
    const Image image = pixels_of(path);
    std::filesystem::remove(path);
    return image;
  }

  std::shared_ptr<const BallSet> balls_ = rod();
  AlphaComplex complex_ = complex_of(balls_, 2);
  AlphaScale scale_{complex_, {.tetrahedra = true}};
  PictureSettings settings_ = plain_settings(balls_->size(), 640, 400);
};

TEST_F(SavedPicture, HasTheScalesColoursAtEverySizeAndBackground) {
  for (const auto& [width, height] : {std::pair{640, 400}, {1920, 1080}, {500, 900}}) {
    settings_.options.width = width;
    settings_.options.height = height;
    for (const bool transparent : {false, true}) {
      settings_.options.background.transparent = transparent;
      settings_.theme = transparent ? Theme::dark : Theme::light;
      EXPECT_EQ(rows_with_scale(save(), scale_), std::lround(10 * mark_unit(width, height)))
          << width << " x " << height << (transparent ? ", transparent" : "");
    }
  }
}

TEST_F(SavedPicture, HasTheBackgroundThatWasChosen) {
  const auto corner = [](const Image& image) {
    return Rgb8{image.rgba[0], image.rgba[1], image.rgba[2]};
  };
  for (const Rgb8& colour : {Rgb8{255, 255, 255}, {0, 0, 0}, {244, 240, 224}, {20, 30, 90}}) {
    settings_.options.background.colour = colour;
    const Image image = save();
    EXPECT_EQ(corner(image), colour);
    // Letters are readable on it, whatever the theme is.
    const bool light = is_light(colour);
    const Colour ink = mark_colours(Theme::dark, settings_.options.background).mark;
    EXPECT_EQ(ink.r < 0.5f, light) << int(colour.b);
  }
}

TEST_F(SavedPicture, HasLettersOfTheChosenSize) {
  settings_.options.width = 1280;
  settings_.options.height = 800;
  settings_.options.legend = false;
  const Image without = save();
  settings_.options.legend = true;
  const auto covered = [&](double letters) {
    settings_.options.letters = letters;
    return unequal_pixels(without, save());
  };
  const int usual = covered(1);
  ASSERT_GT(usual, 500);
  EXPECT_GT(covered(2), 2 * usual);
  EXPECT_LT(covered(0.5), usual);
}

TEST_F(SavedPicture, HasNoLegendWhenThatIsOffOrColoursMeanNothing) {
  settings_.options.legend = false;
  EXPECT_EQ(rows_with_scale(save(), scale_), 0);
  const Image without = save();
  settings_.display.complex_paint.by = ColourBy::single;
  const Image by_balls_without = save();
  settings_.options.legend = true;
  EXPECT_EQ(save().rgba, by_balls_without.rgba);
  EXPECT_NE(without.rgba, by_balls_without.rgba);
}

TEST_F(SavedPicture, HasAScaleBarOnlyWhenAskedFor) {
  const Colour ink = mark_colours(settings_.theme).mark;
  EXPECT_LT(longest_run(save(), ink).length, 20);
  settings_.options.scale_bar = true;
  EXPECT_GE(longest_run(save(), ink).length, 50 * mark_unit(640, 400));
}

// Two lines of sight through the bar's ends meet the focal plane at the distance on the bar.
TEST_F(SavedPicture, HasAScaleBarThatIsTrue) {
  EglContext context;
  Scene scene;
  scene.set_balls(std::make_shared<const BallGeometry>(*balls_), two_colours(balls_->size()));
  for (const int height : {400, 1200}) {
    Image image = scene.grab(2 * height, height, false);
    const MarkColours ink = mark_colours(Theme::dark);
    const double per_pixel = scene.angstrom_per_pixel();
    draw_marks(image, {{}, per_pixel}, ink);
    const PixelRun run = longest_run(image, ink.mark);
    const double thickness = 2 * mark_unit(image.width, image.height);
    const auto on_plane = [&](double x) {
      const Ray middle = scene.ray(image.width / 2.0 - 0.5, image.height / 2.0 - 0.5);
      const Ray ray = scene.ray(x, run.y);
      double start = 0, along = 0;
      for (int k = 0; k < 3; ++k) {
        start += middle.start[k] * middle.direction[k];
        along += ray.direction[k] * middle.direction[k];
      }
      std::array<double, 3> point;
      for (int k = 0; k < 3; ++k) point[k] = ray.start[k] - start / along * ray.direction[k];
      return point;
    };
    const auto a = on_plane(run.x), b = on_plane(run.x + run.length - thickness);
    const double measured = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    const auto layout = lay_out_scale_bar(per_pixel, static_cast<float>(image.width),
                                          static_cast<float>(image.height),
                                          type_of(mark_unit(image.width, image.height)));
    ASSERT_TRUE(layout);
    EXPECT_NEAR(measured, layout->angstrom, 2 * per_pixel) << height;
  }
}

}  // namespace
}  // namespace alphascope::testing
