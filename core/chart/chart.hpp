// SPDX-License-Identifier: GPL-3.0-or-later
// Charts as plain data. layout.hpp lays them out; svg.hpp and the window draw them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alphascope {

struct Rgb8;

// Bars are horizontal, so that the names of many categories stay readable.
enum class ChartKind { bars, stacked_bars, lines };

struct ChartSeries {
  std::string name;
  // bars: one value for each category; lines: one for each of `x`. Empty: not measured.
  std::vector<std::optional<double>> values;
  std::vector<double> x = {};
  // bars: texts to show in place of values or for missing ones, such as "over 20 s". The list may
  // be shorter than `values`; empty texts are skipped.
  std::vector<std::string> notes = {};
};

struct Chart {
  ChartKind kind = ChartKind::bars;
  std::string id;  // base name of a file: "speed-up"
  std::string title;
  std::string value_label, x_label;  // with units: "speed-up (×)"; x_label: of lines only
  std::vector<std::string> categories;
  std::vector<ChartSeries> series;
  // A value to compare with, such as 1× for as fast as CGAL. Bars on a logarithmic axis start
  // there.
  std::optional<double> reference;
  std::string reference_label;
  // Whether the axis of values may be logarithmic. It is so if values span more than a factor of
  // 30.
  bool ratios = false;
  std::string caption;  // machine and program; always shown

  bool empty() const;  // whether no value is set
};

// The colour of the n-th series or category, readable on white and on dark. Colour-blind people can
// tell the colours apart as far as eight allow (Okabe and Ito, 2008). They repeat after eight.
Rgb8 chart_colour(std::size_t n);
inline constexpr std::size_t kChartColours = 8;

}  // namespace alphascope
