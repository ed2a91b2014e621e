// What lies over a picture so that it can be read: the legend of its colours, the scale bar and
// words at places, laid out for whatever can draw boxes and texts. The same in the window and in
// saved pictures; knows neither ImGui nor VTK.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/theme.hpp"

namespace alphascope {

// What the colours of a quantity mean.
struct ColourLegend {
  struct Stop {
    Colour colour;
    double value = 0;  // in the unit that the title says
  };
  std::string title;        // "alpha value (Å²), square-root scale"
  std::vector<Stop> stops;  // evenly along the colour map, smallest value first
};

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
  std::function<float(const std::string&)> text_width;
};

// At the bottom left: quantity and unit above a bar of the colours, and below it the values of its
// ends and middle. Colours of alpha values follow the square root: their middle is a quarter of the
// way from the least value.
struct LegendLayout {
  MarkBox bar;
  std::vector<MarkText> texts;
  MarkBox whole() const;  // bar and texts
  float line_height = 0;
};
// None when the picture is smaller than kLegendRoom, or there are no colours.
inline constexpr float kLegendRoom[2] = {420, 90};  // width and height at scale 1
std::optional<LegendLayout> lay_out_legend(const ColourLegend& legend, float width, float height,
                                           const MarkType& type);

// Words around a place of the picture.
struct PictureLabel {
  float x = 0, y = 0;  // pixels, of the middle of the words
  std::string text;
};
// Those whose place is in the picture, as they come: the first stay where they are, later ones make
// way upwards or downwards as far as there is room.
std::vector<MarkText> lay_out_labels(const std::vector<PictureLabel>& labels, float width,
                                     float height, const MarkType& type);
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

}  // namespace alphascope
