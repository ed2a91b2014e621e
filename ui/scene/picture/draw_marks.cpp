// SPDX-License-Identifier: GPL-3.0-or-later
// Draws masks of coverage, each blended in one colour: first the rims (widened masks), then the
// marks.
#include "ui/scene/picture/draw_marks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "core/geometry/lattice_alpha.hpp"
#include "ui/colour_legend.hpp"
#include "ui/rgb8.hpp"
#include "ui/scene/picture/mark_mask.hpp"

namespace alphascope {
namespace {

using Mask = MarkMask;

constexpr float kFontSize = 14;  // pixels of an em at scale 1
// In a picture of this size, marks are as large as in the window. It suits a column of a printed
// page.
constexpr float kWidthAtScale1 = 960, kHeightAtScale1 = 600;
constexpr float kLeastUnit = 0.7f;  // smaller text cannot be read

std::uint8_t to_byte(float component) {
  return static_cast<std::uint8_t>(component * 255.0f + 0.5f);
}

// Blends a colour over a pixel that may be transparent; neither is premultiplied.
void blend(std::uint8_t* pixel, const Colour& colour, std::uint8_t coverage) {
  const float above = static_cast<float>(coverage) / 255.0f;
  const float below = static_cast<float>(pixel[3]) / 255.0f * (1 - above), all = above + below;
  if (all <= 0) return;
  const float components[3] = {colour.r, colour.g, colour.b};
  for (int c = 0; c < 3; ++c) {
    const float under = static_cast<float>(pixel[c]) / 255.0f;
    pixel[c] = to_byte((components[c] * above + under * below) / all);
  }
  pixel[3] = to_byte(all);
}

// `colour_at` gives the colour of a column, counted from the left of the mask.
template <class ColourAt>
void blend(Image& image, const Mask& mask, const ColourAt& colour_at) {
  for (int y = std::max(0, -mask.y); y < std::min(mask.height, image.height - mask.y); ++y) {
    for (int x = std::max(0, -mask.x); x < std::min(mask.width, image.width - mask.x); ++x) {
      const std::size_t at = std::size_t(mask.y + y) * image.width + (mask.x + x);
      blend(&image.rgba[4 * at], colour_at(x), mask.coverage[std::size_t(y) * mask.width + x]);
    }
  }
}

Colour between(const Colour& a, const Colour& b, float share) {
  return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), 1};
}

Colour colour_of(const ColourLegend& legend, float share) {
  const float at = share * static_cast<float>(legend.stops.size() - 1);
  const std::size_t i = std::min(legend.stops.size() - 2, static_cast<std::size_t>(at));
  return between(legend.stops[i].colour, legend.stops[i + 1].colour, at - static_cast<float>(i));
}

// A part of a legend in the exact colours of the scale. It is drawn over the marks.
struct ColouredMask {
  Mask mask;
  std::function<Colour(int column)> colour_at;  // columns count from the left of the mask
};

struct Placed {
  std::vector<Mask> masks;  // all in one colour
  std::vector<ColouredMask> colours;
  std::string left_out;
};

class MarkMaker {
 public:
  MarkMaker(int width, int height, float letters)
      : letters_(letters),
        width_(static_cast<float>(width)),
        height_(static_cast<float>(height)),
        unit_(letters * mark_unit(width, height)),
        texts_(kFontSize * unit_),
        type_{unit_, texts_.line_height(),
              [this](const std::string& text) { return texts_.width(text); }} {}
  MarkMaker(const MarkMaker&) = delete;
  MarkMaker& operator=(const MarkMaker&) = delete;

  float unit() const { return unit_; }

  void place_legends(const std::vector<ColourLegend>& legends, Placed& placed) const {
    const auto layouts = lay_out_legends(legends, width_, height_, type_);
    if (layouts.size() < legends.size()) too_small("legend", kLegendRoom, placed);
    // lay_out_legends() drops the first legends if there is too little room.
    const std::size_t skipped = legends.size() - layouts.size();
    for (std::size_t i = 0; i < layouts.size(); ++i)
      place(layouts[i], legends[skipped + i], placed);
  }
  void place_scale_bar(double angstrom_per_pixel, Placed& placed) const {
    const auto layout = lay_out_scale_bar(angstrom_per_pixel, width_, height_, type_);
    if (!layout) return too_small("scale bar", kScaleBarRoom, placed);
    for (const MarkBox& line : layout->lines) placed.masks.push_back(mask_of(line));
    placed.masks.push_back(texts_.mask(layout->text));
  }
  void place_caption(const std::vector<std::string>& words, Placed& placed) const {
    const auto layout = lay_out_caption(words, width_, height_, type_);
    if (!layout) return too_small("caption", kCaptionRoom, placed);
    for (const MarkText& line : layout->lines) placed.masks.push_back(texts_.mask(line));
  }
  void place_labels(const std::vector<PictureLabel>& labels, Placed& placed) const {
    const LabelLayout layout = lay_out_labels(labels, width_, height_, type_);
    for (const MarkText& text : layout.texts) placed.masks.push_back(texts_.mask(text));
    if (layout.left_out > 0) add(left_out_text(layout.left_out) + ".", placed);
  }

 private:
  void place(const LegendLayout& layout, const ColourLegend& legend, Placed& placed) const {
    for (const MarkText& text : layout.texts) placed.masks.push_back(texts_.mask(text));
    for (const MarkBox& tick : layout.ticks) placed.masks.push_back(mask_of(tick));
    for (const LegendLayout::Patch& patch : layout.patches) {
      add_colours(
          mask_of(patch.box), [colour = patch.colour](int) { return colour; }, placed);
    }
    if (!layout.bar) return;
    Mask bar = mask_of(*layout.bar);
    const auto width = static_cast<float>(bar.width);
    add_colours(
        std::move(bar),
        [&legend, width](int column) {
          return colour_of(legend, (static_cast<float>(column) + 0.5f) / width);
        },
        placed);
  }
  static void add_colours(Mask mask, std::function<Colour(int)> colour_at, Placed& placed) {
    placed.masks.push_back(mask);
    placed.colours.push_back({std::move(mask), std::move(colour_at)});
  }

  void too_small(const char* what, const float (&room)[2], Placed& placed) const {
    const auto pixels = [this](float v) {
      return std::to_string(static_cast<int>(std::ceil(v * kLeastUnit * letters_)));
    };
    add(std::string("The picture has no ") + what + ", which takes " + pixels(room[0]) + " x " +
            pixels(room[1]) + " pixels at least.",
        placed);
  }
  static void add(const std::string& sentence, Placed& placed) {
    placed.left_out += (placed.left_out.empty() ? "" : " ") + sentence;
  }

  const float letters_, width_, height_, unit_;
  const MarkLetters texts_;
  const MarkFont type_;
};

}  // namespace

void blend(Image& image, const MarkMask& mask, const Colour& colour) {
  blend(image, mask, [&colour](int) { return colour; });
}

MarkColours mark_colours(Theme theme, const PictureBackground& background) {
  if (background.transparent) theme = Theme::light;
  if (background.transparent || !background.colour) {
    return {palette(theme).text, palette(theme).scene};
  }
  const Theme readable = is_light(*background.colour) ? Theme::light : Theme::dark;
  return {palette(readable).text, to_colour(*background.colour)};
}

float mark_unit(int width, int height) {
  return std::max(kLeastUnit, std::min(static_cast<float>(width) / kWidthAtScale1,
                                       static_cast<float>(height) / kHeightAtScale1));
}

std::string draw_marks(Image& image, const PictureMarks& marks, const MarkColours& ink) {
  if (marks.legends.empty() && !marks.angstrom_per_pixel && marks.labels.empty() &&
      marks.caption.empty()) {
    return {};
  }
  const MarkMaker maker(image.width, image.height, marks.letters);
  Placed placed;
  maker.place_legends(marks.legends, placed);
  if (marks.angstrom_per_pixel) maker.place_scale_bar(*marks.angstrom_per_pixel, placed);
  if (!marks.caption.empty()) maker.place_caption(marks.caption, placed);
  maker.place_labels(marks.labels, placed);
  const int rim = std::max(1, static_cast<int>(std::lround(kMarkOutline * maker.unit())));
  for (const Mask& mask : placed.masks) {
    blend(image, rim_of(mask, rim), ink.rim);
  }
  for (const Mask& mask : placed.masks) blend(image, mask, ink.mark);
  for (const ColouredMask& c : placed.colours) blend(image, c.mask, c.colour_at);
  return placed.left_out;
}

Image marked_image(Scene& scene, const MarkedPicture& picture, std::string& left_out,
                   const RunContext& context) {
  context.cancel.throw_if_cancelled();
  Image image = scene.grab(picture.width, picture.height, picture.background.transparent, context);
  PictureMarks marks{
      picture.legends,
      {},
      labels_seen(picture.labels, scene.sight(), picture.cut, picture.width, picture.height),
      picture.caption,
      picture.letters};
  if (picture.scale_bar) marks.angstrom_per_pixel = scene.angstrom_per_pixel();
  left_out += draw_marks(image, marks, mark_colours(picture.theme, picture.background));
  return image;
}

std::string picture_bytes(Scene& scene, const MarkedPicture& picture, const PictureTexts& texts,
                          std::string& left_out, const RunContext& context) {
  return png_bytes(marked_image(scene, picture, left_out, context), texts, picture.dpi);
}

std::string write_picture(Scene& scene, const MarkedPicture& picture,
                          const std::filesystem::path& path, const PictureTexts& texts,
                          const RunContext& context) {
  std::string left_out;
  const Image image = marked_image(scene, picture, left_out, context);
  context.cancel.throw_if_cancelled();
  context.report("writing the file", 0);
  write_png(image, path, texts, context.cancel, picture.dpi);
  return left_out;
}

}  // namespace alphascope
