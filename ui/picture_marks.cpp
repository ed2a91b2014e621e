// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out legends, labels, scale bar and caption, in pixels.
#include "ui/picture_marks.hpp"

#include <algorithm>
#include <cmath>

#include "core/chart/ticks.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/caption.hpp"
#include "ui/colour_legend.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

constexpr float kMargin = 20;                      // from the picture's edge
constexpr float kBarWidth = 180, kBarHeight = 10;  // of the legend
constexpr float kTitleGap = 4, kTickGap = 3, kNumberGap = 8, kStickOut = 10;
constexpr float kEntriesWidth = 260, kPatch = 10, kPatchGap = 5, kEntryGap = 14, kRowGap = 3;
constexpr int kMostRows = 3;  // of categories
constexpr float kLegendGap = 10;
constexpr float kCaptionTop = 14, kLineGap = 3;  // of the caption
constexpr float kLongestLength = 130;            // of the scale bar

bool fits(const float (&room)[2], float width, float height, float unit) {
  return width >= room[0] * unit && height >= room[1] * unit;
}

// Position of a value along the legend's bar, 0 to 1. Values must ascend with the stops.
float share_of(const std::vector<ColourLegend::Stop>& stops, double value) {
  std::size_t i = 1;
  while (i + 1 < stops.size() && stops[i].value < value) ++i;
  const double low = stops[i - 1].value, high = stops[i].value;
  const double within = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0;
  return static_cast<float>((static_cast<double>(i - 1) + within) /
                            static_cast<double>(stops.size() - 1));
}

struct Tick {
  float x = 0;     // position of the tick, from the bar's left end
  float text = 0;  // left end of its number
  std::string number;
};

// Ticks at multiples of `step`.
std::vector<Tick> ticks_at(const ColourLegend& legend, double step, float width,
                           const MarkFont& type) {
  constexpr int kDecimals = 9;  // for multiples of a step with one digit
  std::vector<Tick> ticks;
  const double low = legend.stops.front().value, high = legend.stops.back().value;
  for (const double value : round_values(low, high, step)) {
    Tick tick{width * share_of(legend.stops, value), 0, short_number_text(value, kDecimals)};
    const float length = type.text_width(tick.number);
    // Numbers at the bar's ends may extend beyond the bar by kStickOut.
    const float out = kStickOut * type.unit;
    tick.text = std::clamp(tick.x - length / 2, -out, std::max(-out, width + out - length));
    ticks.push_back(std::move(tick));
  }
  return ticks;
}

// Ticks at as many round numbers as fit without touching. If fewer than two fit, ticks are at the
// ends of the range.
std::vector<Tick> ticks_of(const ColourLegend& legend, float width, const MarkFont& type) {
  const double low = legend.stops.front().value, high = legend.stops.back().value;
  constexpr int kMost = 9;
  for (int most = kMost; most >= 1 && high > low; --most) {
    std::vector<Tick> ticks = ticks_at(legend, nice_step(high - low, most), width, type);
    bool apart = ticks.size() >= 2;
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const float end = ticks[i - 1].text + type.text_width(ticks[i - 1].number);
      apart = apart && ticks[i].text >= end + kNumberGap * type.unit;
    }
    if (apart) return ticks;
  }
  constexpr int kDecimals = 5;
  const std::string first = short_number_text(low, kDecimals);
  const std::string last = short_number_text(high, kDecimals);
  return {{0, 0, first}, {width, std::max(0.0f, width - type.text_width(last)), last}};
}

// Lays out a bar whose numbers end at `bottom`. Returns its top.
float lay_out_bar(const ColourLegend& legend, float bottom, const MarkFont& type,
                  LegendLayout& layout) {
  const float u = type.unit, left = kMargin * u;
  const float top = bottom - (kTickGap + kBarHeight) * u - type.line_height;
  const MarkBox bar{left, top, left + kBarWidth * u, top + kBarHeight * u};
  layout.bar = bar;
  for (const Tick& tick : ticks_of(legend, kBarWidth * u, type)) {
    const float x = std::clamp(left + tick.x, bar.x0 + u / 2, bar.x1 - u / 2);
    layout.ticks.push_back({x - u / 2, bar.y1, x + u / 2, bar.y1 + kTickGap * u});
    layout.texts.push_back({left + tick.text, bar.y1 + kTickGap * u, tick.number});
  }
  layout.whole.x1 = std::max(layout.whole.x1, bar.x1 + kStickOut * u);
  return top;
}

// Places patches and names in rows from (0, 0). Returns false if these are more than kMostRows.
bool lay_out_rows(const std::vector<ColourLegend::Entry>& entries, std::size_t shown, float width,
                  const MarkFont& type, LegendLayout& rows) {
  const float u = type.unit, patch = kPatch * u, line = type.line_height + kRowGap * u;
  float x = 0, y = 0;
  const auto place = [&](const std::string& text, float before) {
    const float length = before + type.text_width(text);
    if (x > 0 && x + length > width) x = 0, y += line;
    rows.texts.push_back({x + before, y, text});
    rows.whole.x1 = std::max(rows.whole.x1, x + length);
    x += length + kEntryGap * u;
  };
  for (std::size_t i = 0; i < shown; ++i) {
    place(entries[i].name, patch + kPatchGap * u);
    const MarkText& name = rows.texts.back();
    const float left = name.x - patch - kPatchGap * u;
    const float top = name.y + (type.line_height - patch) / 2;
    rows.patches.push_back({{left, top, left + patch, top + patch}, entries[i].colour});
  }
  if (shown < entries.size()) place("and " + grouped(entries.size() - shown) + " more", 0);
  rows.whole.y1 = y + type.line_height;
  return y < kMostRows * line - line / 2;
}

// Lays out rows that end at `bottom`. Returns their top.
float lay_out_entries(const ColourLegend& legend, float bottom, float width, const MarkFont& type,
                      LegendLayout& layout) {
  const float u = type.unit;
  const float room = std::min(kEntriesWidth * u, width / 2 - kMargin * u);
  LegendLayout rows;
  constexpr std::size_t kMostEntries = 60;
  for (std::size_t shown = std::min(kMostEntries, legend.entries.size());; --shown) {
    rows = {};
    if (lay_out_rows(legend.entries, shown, room, type, rows) || shown <= 1) break;
  }
  const float left = kMargin * u, top = bottom - rows.whole.y1;
  for (LegendLayout::Patch& patch : rows.patches) {
    MarkBox& b = patch.box;
    layout.patches.push_back({{b.x0 + left, b.y0 + top, b.x1 + left, b.y1 + top}, patch.colour});
  }
  for (const MarkText& text : rows.texts) {
    layout.texts.push_back({text.x + left, text.y + top, text.text});
  }
  layout.whole.x1 = left + rows.whole.x1;
  return top;
}

bool overlap(const MarkBox& a, const MarkBox& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

MarkBox shifted(MarkBox box, float down) {
  box.y0 += down;
  box.y1 += down;
  return box;
}

// Moves the box up or down until it covers no other box, by as few of its heights as needed. If
// four heights are too few, the result is empty.
std::optional<MarkBox> free_place(const MarkBox& box, const std::vector<MarkBox>& others,
                                  float height) {
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
  return std::nullopt;
}

}  // namespace

std::optional<LegendLayout> lay_out_legend(const ColourLegend& legend, float width, float height,
                                           const MarkFont& type) {
  const float u = type.unit, bottom = height - (kMargin - kTickGap) * u;
  const bool quantity = legend.stops.size() >= 2;
  if ((!quantity && legend.entries.empty()) || !fits(kLegendRoom, width, height, u)) {
    return std::nullopt;
  }
  LegendLayout layout;
  layout.texts.push_back({kMargin * u, 0, legend.title});
  float top = bottom;
  if (!legend.entries.empty()) top = lay_out_entries(legend, top, width, type, layout);
  if (quantity) {
    if (top < bottom) top -= kRowGap * u;
    top = lay_out_bar(legend, top, type, layout);
  }
  MarkText& title = layout.texts[0];
  title.y = top - kTitleGap * u - type.line_height;
  const float right = std::max(layout.whole.x1, title.x + type.text_width(title.text));
  layout.whole = {title.x, title.y, right, bottom};
  return layout;
}

std::vector<LegendLayout> lay_out_legends(const std::vector<ColourLegend>& legends, float width,
                                          float height, const MarkFont& type) {
  std::vector<LegendLayout> layouts;
  for (auto legend = legends.rbegin(); legend != legends.rend(); ++legend) {
    auto layout = lay_out_legend(*legend, width, height, type);
    if (!layout) break;
    // The next legend lies above the title of this one.
    height = layout->whole.y0 + (kMargin - kTickGap - kLegendGap) * type.unit;
    layouts.insert(layouts.begin(), *std::move(layout));
  }
  return layouts;
}

LabelLayout lay_out_labels(const std::vector<PictureLabel>& labels, float width, float height,
                           const MarkFont& type) {
  LabelLayout layout;
  std::vector<MarkBox> taken;
  const float rim = kMarkOutline * type.unit;
  for (const PictureLabel& label : labels) {
    const bool inside = label.x >= 0 && label.x <= width && label.y >= 0 && label.y <= height;
    if (!inside || label.text.empty()) continue;
    const float half = type.text_width(label.text) / 2 + rim, up = type.line_height / 2 + rim;
    // Texts near an edge are moved into the picture, if it is wide enough for them.
    const float x = std::max(half, std::min(label.x, width - half));
    const float y = std::max(up, std::min(label.y, height - up));
    const auto place = free_place({x - half, y - up, x + half, y + up}, taken, height);
    if (!place) {
      ++layout.left_out;
      continue;
    }
    taken.push_back(*place);
    layout.texts.push_back({place->x0 + rim, place->y0 + rim, label.text});
  }
  return layout;
}

std::string left_out_text(std::size_t labels) {
  if (labels == 0) return {};
  return counted(labels, "label has", "labels have") + " no room here: zoom in";
}

std::optional<ScaleBarLayout> lay_out_scale_bar(double angstrom_per_pixel, float width,
                                                float height, const MarkFont& type) {
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

std::optional<CaptionLayout> lay_out_caption(const std::vector<std::string>& words, float width,
                                             float height, const MarkFont& type) {
  const float u = type.unit, room = width - 2 * kMargin * u;
  if (words.empty() || !fits(kCaptionRoom, width, height, u)) return std::nullopt;
  std::vector<std::string> lines;
  for (const std::string& word : words) {
    const std::string longer = lines.empty() ? word : lines.back() + kCaptionGap + word;
    if (!lines.empty() && type.text_width(longer) <= room) {
      lines.back() = longer;
    } else {
      lines.push_back(fitted_text(word, room, type.text_width));
    }
  }
  const float step = type.line_height + kLineGap * u, top = kCaptionTop * u;
  if (top + step * static_cast<float>(lines.size()) > height / 2) return std::nullopt;
  CaptionLayout layout;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    layout.lines.push_back({kMargin * u, top + step * static_cast<float>(k), lines[k]});
  }
  return layout;
}

}  // namespace alphascope
