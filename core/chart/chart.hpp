// Charts as plain data. How they are laid out is layout.hpp's business, how they are drawn
// svg.hpp's and the window's.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alphascope {

// Bars lie, so that the names of many categories stay readable.
enum class ChartKind { bars, stacked_bars, lines };

struct ChartSeries {
  std::string name;
  // bars: one a category, empty where nothing was measured. lines: one for each of `x`, likewise.
  std::vector<std::optional<double>> values;
  std::vector<double> x = {};
  // bars: said instead of the number, or where there is none, "over 20 s"; may be shorter than
  // `values`, and empty.
  std::vector<std::string> notes = {};
};

struct Chart {
  ChartKind kind = ChartKind::bars;
  std::string id;  // of a file: "speed-up"
  std::string title;
  std::string value_label, x_label;  // with units: "speed-up (×)"; x of lines only
  std::vector<std::string> categories;
  std::vector<ChartSeries> series;
  // A value to compare with, such as 1× for as fast as CGAL. Bars on a logarithmic axis start
  // there.
  std::optional<double> reference;
  std::string reference_label;
  // Allows a logarithmic axis of values, which is taken where they span more than a factor of 30.
  bool ratios = false;
  std::string caption;  // machine and program; always shown

  bool empty() const;  // no value at all
};

struct ChartColour {
  unsigned char r, g, b;
};
// Of the n-th series; readable on white and on dark, told apart by colour-blind people as far as
// eight colours can be (Okabe and Ito, 2008). Repeats after eight.
ChartColour chart_colour(std::size_t n);
inline constexpr std::size_t kChartColours = 8;

}  // namespace alphascope
