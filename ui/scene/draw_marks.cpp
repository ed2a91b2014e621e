// See the header. Everything is a mask of coverage that is blended in one colour: first the rims,
// widened masks, then the marks.
#include "ui/scene/draw_marks.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace alphascope {
namespace {

constexpr int kDotsPerInch = 72;  // then VTK's points are pixels
constexpr float kFontSize = 15;   // pixels of an em at scale 1
// A picture of this size has marks as large as the window's; a column of a page shows it well.
constexpr float kWidthAtScale1 = 960, kHeightAtScale1 = 600;
constexpr float kLeastUnit = 0.7f;  // smaller text cannot be read

// Coverage, 0 to 255, of a part of the picture that may stick out of it; top row first.
struct Mask {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
};

class TextMaker {
 public:
  explicit TextMaker(float unit) {
    renderer_ = vtkTextRenderer::GetInstance();
    if (renderer_ == nullptr)
      throw std::runtime_error("VTK brings no fonts, so nothing is written");
    renderer_->SetScaleToPowerOfTwo(false);
    property_->SetFontFamilyToArial();  // VTK's own: the same on every machine
    property_->SetFontSize(static_cast<int>(std::lround(kFontSize * unit)));
  }

  Mask mask(const MarkText& text) const {
    vtkNew<vtkImageData> image;
    int size[2] = {0, 0};
    if (!renderer_->RenderString(property_, vtkStdString(text.text), image, size, kDotsPerInch,
                                 vtkTextRenderer::FreeType)) {
      throw std::runtime_error("VTK could not write \"" + text.text + "\" into the picture");
    }
    Mask mask{static_cast<int>(std::lround(text.x)), 0, size[0], size[1], {}};
    mask.coverage.resize(std::size_t(size[0]) * size[1]);
    const int* extent = image->GetExtent();
    for (int row = 0; row < size[1]; ++row) {  // VTK's first row is the bottom
      for (int column = 0; column < size[0]; ++column) {
        const auto* pixel = static_cast<const std::uint8_t*>(
            image->GetScalarPointer(extent[0] + column, extent[2] + size[1] - 1 - row, extent[4]));
        mask.coverage[std::size_t(row) * size[0] + column] = pixel[3];
      }
    }
    // Texts are of different height but have their descenders' line in common.
    mask.y = static_cast<int>(std::lround(text.y + line_height())) - size[1];
    return mask;
  }
  float width(const std::string& text) const { return static_cast<float>(extent(text, 0)); }
  float line_height() const { return static_cast<float>(extent("(Å²), pq", 2)); }

 private:
  int extent(const std::string& text, int low) const {
    int box[4] = {0, 0, 0, 0};
    renderer_->GetBoundingBox(property_, vtkStdString(text), box, kDotsPerInch,
                              vtkTextRenderer::FreeType);
    return box[low + 1] - box[low] + 1;
  }

  vtkTextRenderer* renderer_ = nullptr;
  vtkNew<vtkTextProperty> property_;
};

Mask mask_of(const MarkBox& box) {
  const auto whole = [](float v) { return static_cast<int>(std::lround(v)); };
  Mask mask{whole(box.x0), whole(box.y0), 0, 0, {}};
  mask.width = std::max(1, whole(box.x1) - mask.x);
  mask.height = std::max(1, whole(box.y1) - mask.y);
  mask.coverage.assign(std::size_t(mask.width) * mask.height, 255);
  return mask;
}

// The largest coverage within `reach` pixels along a row; a second time, transposed, along columns.
Mask widened_and_transposed(const Mask& mask, int reach) {
  Mask result{mask.y, mask.x - reach, mask.height, mask.width + 2 * reach, {}};
  result.coverage.resize(std::size_t(result.width) * result.height);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const std::uint8_t value = mask.coverage[std::size_t(y) * mask.width + x];
      if (value == 0) continue;
      for (int k = 0; k <= 2 * reach; ++k) {
        std::uint8_t& target = result.coverage[std::size_t(x + k) * result.width + y];
        target = std::max(target, value);
      }
    }
  }
  return result;
}

Mask rim_of(const Mask& mask, int reach) {
  return widened_and_transposed(widened_and_transposed(mask, reach), reach);
}

std::uint8_t to_byte(float component) {
  return static_cast<std::uint8_t>(component * 255.0f + 0.5f);
}

// Of colours that are not premultiplied, over what may be transparent.
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

// `colour_at` of a column, counted from the mask's left.
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

struct Placed {
  std::vector<Mask> masks;      // all in one colour
  std::optional<Mask> colours;  // the legend's bar
  std::string left_out;
};

class MarkMaker {
 public:
  MarkMaker(int width, int height)
      : width_(static_cast<float>(width)),
        height_(static_cast<float>(height)),
        unit_(mark_unit(width, height)),
        texts_(unit_),
        type_{unit_, texts_.line_height(),
              [this](const std::string& text) { return texts_.width(text); }} {}
  MarkMaker(const MarkMaker&) = delete;
  MarkMaker& operator=(const MarkMaker&) = delete;

  float unit() const { return unit_; }

  void place_legend(const ColourLegend& legend, Placed& placed) const {
    const auto layout = lay_out_legend(legend, width_, height_, type_);
    if (!layout) return too_small("legend", kLegendRoom, placed);
    for (const MarkText& text : layout->texts) placed.masks.push_back(texts_.mask(text));
    placed.colours = mask_of(layout->bar);
    placed.masks.push_back(*placed.colours);
  }
  void place_scale_bar(double angstrom_per_pixel, Placed& placed) const {
    const auto layout = lay_out_scale_bar(angstrom_per_pixel, width_, height_, type_);
    if (!layout) return too_small("scale bar", kScaleBarRoom, placed);
    for (const MarkBox& line : layout->lines) placed.masks.push_back(mask_of(line));
    placed.masks.push_back(texts_.mask(layout->text));
  }
  void place_labels(const std::vector<PictureLabel>& labels, Placed& placed) const {
    for (const MarkText& text : lay_out_labels(labels, width_, height_, type_)) {
      placed.masks.push_back(texts_.mask(text));
    }
  }

 private:
  static void too_small(const char* what, const float (&room)[2], Placed& placed) {
    const auto pixels = [](float v) {
      return std::to_string(static_cast<int>(std::ceil(v * kLeastUnit)));
    };
    placed.left_out += std::string(placed.left_out.empty() ? "" : " ") + "The picture has no " +
                       what + ", which takes " + pixels(room[0]) + " x " + pixels(room[1]) +
                       " pixels at least.";
  }

  const float width_, height_, unit_;
  const TextMaker texts_;
  const MarkType type_;
};

}  // namespace

MarkInk mark_ink(Theme theme, bool transparent) {
  const Palette& p = palette(transparent ? Theme::light : theme);
  return {p.text, p.scene};
}

float mark_unit(int width, int height) {
  return std::max(kLeastUnit, std::min(static_cast<float>(width) / kWidthAtScale1,
                                       static_cast<float>(height) / kHeightAtScale1));
}

std::string draw_marks(Image& image, const PictureMarks& marks, const MarkInk& ink) {
  if (!marks.legend && !marks.angstrom_per_pixel && marks.labels.empty()) return {};
  const MarkMaker maker(image.width, image.height);
  Placed placed;
  if (marks.legend) maker.place_legend(*marks.legend, placed);
  if (marks.angstrom_per_pixel) maker.place_scale_bar(*marks.angstrom_per_pixel, placed);
  maker.place_labels(marks.labels, placed);
  const int rim = std::max(1, static_cast<int>(std::lround(kMarkOutline * maker.unit())));
  for (const Mask& mask : placed.masks) {
    blend(image, rim_of(mask, rim), [&](int) { return ink.rim; });
  }
  for (const Mask& mask : placed.masks) blend(image, mask, [&](int) { return ink.mark; });
  if (placed.colours) {
    const auto width = static_cast<float>(placed.colours->width);
    blend(image, *placed.colours, [&](int column) {
      return colour_of(*marks.legend, (static_cast<float>(column) + 0.5f) / width);
    });
  }
  return placed.left_out;
}

std::string write_picture(Scene& scene, const MarkedPicture& picture,
                          const std::filesystem::path& path, const PictureTexts& texts,
                          const RunContext& context) {
  context.cancel.throw_if_cancelled();
  Image image = scene.grab(picture.width, picture.height, picture.transparent, context);
  PictureMarks marks{
      picture.legend,
      {},
      labels_seen(picture.labels, scene.sight(), picture.cut, picture.width, picture.height)};
  if (picture.scale_bar) marks.angstrom_per_pixel = scene.angstrom_per_pixel();
  std::string left_out = draw_marks(image, marks, mark_ink(picture.theme, picture.transparent));
  context.cancel.throw_if_cancelled();
  context.report("writing the file", 0);
  write_png(image, path, texts, context.cancel);
  return left_out;
}

}  // namespace alphascope
