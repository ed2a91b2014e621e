// What lies over a picture so that it can be read: the legend of its colours, the scale bar and
// words at places, laid out for whatever can draw boxes and texts. The same in the window and in
// saved pictures; knows neither ImGui nor VTK.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/colour_legend.hpp"
#include "ui/fitted_text.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// Pixels from the picture's top left; y points down.
struct MarkBox {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
struct MarkText {
  float x = 0, y = 0;  // top left of its line
  std::string text;
};

struct MarkType {
  float unit = 1;          // pixels of the picture that are one at scale 1
  float line_height = 14;  // pixels
  TextWidth text_width;
};

// At the bottom left. Of a quantity: its name and unit above a bar of the colours, and below that
// round values at ticks. Of categories, and of what has no value: a patch of colour before each
// name, in a few rows; those that find no room there are counted.
struct LegendLayout {
  struct Patch {
    MarkBox box;
    Colour colour;
  };
  std::vector<MarkText> texts;  // the title first
  std::optional<MarkBox> bar;
  std::vector<MarkBox> ticks;
  std::vector<Patch> patches;
  MarkBox whole;
};
// None when the picture is smaller than kLegendRoom, or there are no colours.
inline constexpr float kLegendRoom[2] = {420, 90};  // width and height at scale 1
std::optional<LegendLayout> lay_out_legend(const ColourLegend& legend, float width, float height,
                                           const MarkType& type);
// One above the other, the last one lowest; those that have no room are left out.
std::vector<LegendLayout> lay_out_legends(const std::vector<ColourLegend>& legends, float width,
                                          float height, const MarkType& type);

// Words around a place of the picture.
struct PictureLabel {
  float x = 0, y = 0;  // pixels, of the middle of the words
  std::string text;
};
// Those whose place is in the picture, as they come: the first stay where they are, later ones make
// way upwards or downwards by a few lines. What finds no room there is left out: words on words can
// not be read.
struct LabelLayout {
  std::vector<MarkText> texts;
  std::size_t left_out = 0;
};
LabelLayout lay_out_labels(const std::vector<PictureLabel>& labels, float width, float height,
                           const MarkType& type);
// "3 labels have no room here: zoom in"; empty for none.
std::string left_out_text(std::size_t labels);
// Pixels at scale 1 by which an outline in the background's colour surrounds marks.
inline constexpr float kMarkOutline = 2;

// At the bottom right: a round length of 52 to 130 pixels at scale 1.
struct ScaleBarLayout {
  std::array<MarkBox, 3> lines;  // the length, and its ends
  MarkText text;                 // "10 Å"
  double angstrom = 0;
};
// None when the picture is smaller than kScaleBarRoom, or nothing has a size.
inline constexpr float kScaleBarRoom[2] = {180, 60};
std::optional<ScaleBarLayout> lay_out_scale_bar(double angstrom_per_pixel, float width,
                                                float height, const MarkType& type);

// At the top left: the words of a caption (ui/caption.hpp), as many on a line as fit. Words that
// are longer than a line are cut in their middle.
struct CaptionLayout {
  std::vector<MarkText> lines;
};
// None when the picture is smaller than kCaptionRoom, when the lines would take more than half of
// its height, or when there are no words.
inline constexpr float kCaptionRoom[2] = {180, 60};
std::optional<CaptionLayout> lay_out_caption(const std::vector<std::string>& words, float width,
                                             float height, const MarkType& type);

}  // namespace alphascope
