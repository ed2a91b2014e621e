// Legend and scale bar: laid out for the window, and drawn into pictures that are saved.
#include "ui/picture_marks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "tests/ui/molecule_fixture.hpp"
#include "tests/ui/png_pixels.hpp"
#include "ui/scene/draw_marks.hpp"
#include "ui/scene/screenshot.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope::testing {
namespace {

constexpr float kLine = 14;

MarkType type_of(float unit) {
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

// Rows that show the whole scale, from the first colour to the last, where the legend's bar is.
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
  const auto layout = lay_out_legend(legend_from(-3.25, 1.4), 960, 500, type_of(1));
  ASSERT_TRUE(layout);
  ASSERT_EQ(layout->texts.size(), 4u);
  EXPECT_EQ(layout->texts[0].text, "alpha value (Å²), square-root scale");
  EXPECT_EQ(layout->texts[1].text, "−3.25");
  EXPECT_EQ(layout->texts[2].text, "−0.92");
  EXPECT_EQ(layout->texts[3].text, "1.4");
  EXPECT_FLOAT_EQ(layout->texts[1].x, layout->bar.x0);
  EXPECT_FLOAT_EQ(layout->texts[3].x + 7 * 3, layout->bar.x1);
  EXPECT_LE(layout->whole().y1, 500);
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

TEST(PictureMarks, NothingAskedForChangesNothing) {
  Image image = plain(640, 400, palette(Theme::dark).scene);
  const std::vector<std::uint8_t> before = image.rgba;
  EXPECT_EQ(draw_marks(image, {}, mark_ink(Theme::dark, false)), "");
  EXPECT_EQ(image.rgba, before);
}

TEST(PictureMarks, TextContrastsWithEveryBackground) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    for (const bool transparent : {false, true}) {
      const MarkInk ink = mark_ink(theme, transparent);
      const Colour background = transparent ? Colour{0, 0, 0, 0} : palette(theme).scene;
      Image image = plain(960, 600, background, transparent ? 0 : 255);
      draw_marks(image, {legend_from(0, 1), 0.1}, ink);
      int marked = 0, rim = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const bool opaque = image.rgba[i + 3] == 255;
        marked += opaque && same_colour(&image.rgba[i], ink.mark, 2);
        rim += opaque && same_colour(&image.rgba[i], ink.rim, 2);
      }
      EXPECT_GT(marked, 300);  // the scale bar's lines alone are 200
      EXPECT_GT(rim, 1000);
      EXPECT_GT(std::fabs(ink.mark.g - ink.rim.g), 0.6);
      EXPECT_EQ(image.rgba[3], transparent ? 0 : 255) << "the rest stays as it was";
    }
  }
}

TEST(PictureMarks, TooSmallAPictureSaysSo) {
  Image image = plain(200, 150, palette(Theme::light).scene);
  const std::string said =
      draw_marks(image, {legend_from(0, 1), 0.1}, mark_ink(Theme::light, false));
  EXPECT_NE(said.find("no legend, which takes 294 x 63 pixels"), std::string::npos) << said;
  EXPECT_EQ(said.find("no scale bar"), std::string::npos) << said;
  image = plain(294, 63, palette(Theme::light).scene);
  EXPECT_EQ(draw_marks(image, {legend_from(0, 1), 0.1}, mark_ink(Theme::light, false)), "");
}

class SavedPicture : public ::testing::Test {
 protected:
  SavedPicture() {
    options_.width = 640;
    options_.height = 400;
    options_.mesh.colouring = ComplexColouring::alpha;
  }
  Image save() {
    const auto path = std::filesystem::temp_directory_path() /
                      ("alphascope_marks_" + std::to_string(getpid()) + ".png");
    render_screenshot(*balls_, complex_, two_colours(balls_->size()), options_, path);
    const Image image = pixels_of(path);
    std::filesystem::remove(path);
    return image;
  }

  std::shared_ptr<const BallSet> balls_ = rod();
  AlphaComplex complex_ = complex_of(balls_, 2);
  AlphaScale scale_{complex_, {.tetrahedra = true}};
  ScreenshotOptions options_;
};

TEST_F(SavedPicture, HasTheScalesColoursAtEverySizeAndBackground) {
  for (const auto& [width, height] : {std::pair{640, 400}, {1920, 1080}, {500, 900}}) {
    options_.width = width;
    options_.height = height;
    for (const bool transparent : {false, true}) {
      options_.transparent = transparent;
      options_.style.theme = transparent ? Theme::dark : Theme::light;
      EXPECT_EQ(rows_with_scale(save(), scale_), std::lround(10 * mark_unit(width, height)))
          << width << " x " << height << (transparent ? ", transparent" : "");
    }
  }
}

TEST_F(SavedPicture, HasNoLegendWhenThatIsOffOrColoursMeanNothing) {
  options_.legend = false;
  EXPECT_EQ(rows_with_scale(save(), scale_), 0);
  const Image without = save();
  options_.mesh.colouring = ComplexColouring::balls;
  const Image by_balls_without = save();
  options_.legend = true;
  EXPECT_EQ(save().rgba, by_balls_without.rgba);
  EXPECT_NE(without.rgba, by_balls_without.rgba);
}

TEST_F(SavedPicture, HasAScaleBarOnlyWhenAskedFor) {
  const Colour ink = mark_ink(options_.style.theme, false).mark;
  EXPECT_LT(longest_run(save(), ink).length, 20);
  options_.scale_bar = true;
  EXPECT_GE(longest_run(save(), ink).length, 50 * mark_unit(640, 400));
}

// Two lines of sight through the bar's ends meet the plane that the camera looks at as far apart as
// the bar says.
TEST_F(SavedPicture, HasAScaleBarThatIsTrue) {
  EglContext context;
  Scene scene;
  scene.set_balls(std::make_shared<const BallGeometry>(*balls_), two_colours(balls_->size()));
  for (const int height : {400, 1200}) {
    Image image = scene.grab(2 * height, height, false);
    const MarkInk ink = mark_ink(Theme::dark, false);
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
