// See the header.
#include "ui/picture_marks.hpp"

#include <algorithm>
#include <cmath>

#include "ui/number_text.hpp"

namespace alphascope {
namespace {

constexpr float kMargin = 20;                      // from the picture's edge
constexpr float kBarWidth = 180, kBarHeight = 10;  // of the legend
constexpr float kTitleGap = 4, kTickGap = 3;
constexpr float kLongestLength = 130;  // of the scale bar

bool fits(const float (&room)[2], float width, float height, float unit) {
  return width >= room[0] * unit && height >= room[1] * unit;
}

// Two decimals, and more where they would say the same of different colours.
std::vector<std::string> tick_texts(const std::array<double, 3>& values) {
  constexpr int kFewest = 2, kMost = 5;
  std::vector<std::string> texts;
  for (int decimals = kFewest; decimals <= kMost; ++decimals) {
    texts.clear();
    for (const double value : values) texts.push_back(short_number_text(value, decimals));
    if (texts[0] != texts[1] && texts[1] != texts[2]) break;
  }
  return texts;
}

bool overlap(const MarkBox& a, const MarkBox& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

MarkBox shifted(MarkBox box, float down) {
  box.y0 += down;
  box.y1 += down;
  return box;
}

// The nearest of a few heights at which the box covers no other; its own where there is none.
MarkBox free_place(const MarkBox& box, const std::vector<MarkBox>& others, float height) {
  constexpr int kMostSteps = 4;
  for (int step = 0; step <= 2 * kMostSteps; ++step) {
    const int lines = (step + 1) / 2 * (step % 2 == 0 ? 1 : -1);
    const MarkBox tried = shifted(box, static_cast<float>(lines) * (box.y1 - box.y0));
    const bool inside = step == 0 || (tried.y0 >= 0 && tried.y1 <= height);
    if (inside && std::none_of(others.begin(), others.end(),
                               [&](const MarkBox& o) { return overlap(tried, o); })) {
      return tried;
    }
  }
  return box;
}

}  // namespace

MarkBox LegendLayout::whole() const {
  return {bar.x0, texts.front().y, bar.x1, texts.back().y + line_height};
}

std::optional<LegendLayout> lay_out_legend(const ColourLegend& legend, float width, float height,
                                           const MarkType& type) {
  const auto& stops = legend.stops;
  const float u = type.unit, line = type.line_height;
  if (stops.size() < 2 || !fits(kLegendRoom, width, height, u)) return std::nullopt;
  LegendLayout layout;
  layout.line_height = line;
  const float left = kMargin * u, top = height - kMargin * u - line - kBarHeight * u;
  layout.bar = {left, top, left + kBarWidth * u, top + kBarHeight * u};
  layout.texts.push_back({left, top - kTitleGap * u - line, legend.title});
  const std::vector<std::string> ticks =
      tick_texts({stops.front().value, stops[(stops.size() - 1) / 2].value, stops.back().value});
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    // The outer ones end with the bar, so that none sticks out.
    const float share = static_cast<float>(i) / static_cast<float>(ticks.size() - 1);
    const float shift = share * (kBarWidth * u - type.text_width(ticks[i]));
    layout.texts.push_back({left + shift, layout.bar.y1 + kTickGap * u, ticks[i]});
  }
  return layout;
}

std::vector<MarkText> lay_out_labels(const std::vector<PictureLabel>& labels, float width,
                                     float height, const MarkType& type) {
  std::vector<MarkText> texts;
  std::vector<MarkBox> taken;
  const float rim = kMarkOutline * type.unit;
  for (const PictureLabel& label : labels) {
    const bool inside = label.x >= 0 && label.x <= width && label.y >= 0 && label.y <= height;
    if (!inside || label.text.empty()) continue;
    const float half = type.text_width(label.text) / 2 + rim, up = type.line_height / 2 + rim;
    // Words near an edge are moved into the picture, if it is wide enough for them.
    const float x = std::max(half, std::min(label.x, width - half));
    const float y = std::max(up, std::min(label.y, height - up));
    taken.push_back(free_place({x - half, y - up, x + half, y + up}, taken, height));
    texts.push_back({taken.back().x0 + rim, taken.back().y0 + rim, label.text});
  }
  return texts;
}

std::optional<ScaleBarLayout> lay_out_scale_bar(double angstrom_per_pixel, float width,
                                                float height, const MarkType& type) {
  const float u = type.unit;
  if (!(angstrom_per_pixel > 0) || !fits(kScaleBarRoom, width, height, u)) return std::nullopt;
  const double longest = angstrom_per_pixel * kLongestLength * u;
  double length = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (length * factor <= longest) length *= factor;
  }
  ScaleBarLayout layout;
  layout.angstrom = length;
  const float pixels = static_cast<float>(length / angstrom_per_pixel);
  const float x1 = width - kMargin * u, x0 = x1 - pixels, y = height - 18 * u;
  layout.lines[0] = {x0 - u, y - u, x1 + u, y + u};
  layout.lines[1] = {x0 - u, y - 4 * u, x0 + u, y + 4 * u};
  layout.lines[2] = {x1 - u, y - 4 * u, x1 + u, y + 4 * u};
  layout.text.text = short_number_text(length, 3) + " Å";
  layout.text.x = (x0 + x1 - type.text_width(layout.text.text)) / 2;
  layout.text.y = y - 7 * u - type.line_height;
  return layout;
}

}  // namespace alphascope
