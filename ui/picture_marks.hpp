// SPDX-License-Identifier: GPL-3.0-or-later
// Marks over a picture: the legend of its colours, the scale bar, the caption and labels. They are
// laid out as boxes and texts, for the window and for saved pictures alike. Neither ImGui nor VTK.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/fitted_text.hpp"
#include "ui/theme.hpp"

namespace alphascope {

struct ColourLegend;

// Pixels from the picture's top left; y points down.
struct MarkBox {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
struct MarkText {
  float x = 0, y = 0;  // top left of its line
  std::string text;
};

struct MarkFont {
  float unit = 1;          // pixels of the picture for each pixel at scale 1
  float line_height = 14;  // pixels
  TextWidth text_width;
};

// A legend at the bottom left. For a quantity it has name and unit above a bar of the colours, and
// round values at ticks below. For categories it has a patch of colour before each name, in a few
// rows. A number tells how many names have no room. Objects without a value have a patch and a name
// as well.
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
// None if the picture is smaller than kLegendRoom, or if there are no colours.
inline constexpr float kLegendRoom[2] = {420, 90};  // width and height at scale 1
std::optional<LegendLayout> lay_out_legend(const ColourLegend& legend, float width, float height,
                                           const MarkFont& type);
// Legends above one another, the last one lowest. Legends without room are left out.
std::vector<LegendLayout> lay_out_legends(const std::vector<ColourLegend>& legends, float width,
                                          float height, const MarkFont& type);

// Text around a point of the picture.
struct PictureLabel {
  float x = 0, y = 0;  // pixels, of the middle of the text
  std::string text;
};
// Labels whose points are in the picture. They are placed in the given order. Each is moved up or
// down by a few lines, until it covers no earlier one. Labels without room are left out, because
// overlapping text cannot be read.
struct LabelLayout {
  std::vector<MarkText> texts;
  std::size_t left_out = 0;
};
LabelLayout lay_out_labels(const std::vector<PictureLabel>& labels, float width, float height,
                           const MarkFont& type);
// "3 labels have no room here: zoom in"; empty for 0.
std::string left_out_text(std::size_t labels);
// Width of the outline around marks, pixels at scale 1. It has the background's colour.
inline constexpr float kMarkOutline = 2;

// A scale bar at the bottom right: a round length of 52 to 130 pixels at scale 1.
struct ScaleBarLayout {
  std::array<MarkBox, 3> lines;  // the length, and a line at each end
  MarkText text;                 // "10 Å"
  double angstrom = 0;
};
// None if the picture is smaller than kScaleBarRoom, or if `angstrom_per_pixel` is not positive.
inline constexpr float kScaleBarRoom[2] = {180, 60};
std::optional<ScaleBarLayout> lay_out_scale_bar(double angstrom_per_pixel, float width,
                                                float height, const MarkFont& type);

// A caption at the top left: words (ui/caption.hpp), as many on a line as fit. Words longer than a
// line are shortened in their middle.
struct CaptionLayout {
  std::vector<MarkText> lines;
};
// None if there are no words, or if the picture is smaller than kCaptionRoom. Also none if the
// lines would take more than half of its height.
inline constexpr float kCaptionRoom[2] = {180, 60};
std::optional<CaptionLayout> lay_out_caption(const std::vector<std::string>& words, float width,
                                             float height, const MarkFont& type);

}  // namespace alphascope
