// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page of curves between frames. Plain data.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/cavities/cavity_chart.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/panels/measures/lives_state.hpp"

namespace alphascope {

struct CavityLines;
struct CavityTrace;

struct CurveState {
  static constexpr int kLives = 4;  // not a CurveQuantity

  int axis = 1;          // a CurveAxis
  int quantity = 0;      // a CurveQuantity, or kLives
  std::string molecule;  // SHA-256 of the molecule's file
  // Curves of large molecules take long, so the user starts them. This is the axis and the quantity
  // for which the user did; −1: none.
  std::pair<int, int> asked_for{-1, -1};

  // The chart, and the results from which it was made.
  CavityChart chart;
  std::vector<Rgb8> colours;  // one for each series
  CurveAxis chart_axis{};     // of alpha
  std::shared_ptr<const void> curves, links;
  std::shared_ptr<const CavityTrace> trace;  // null: the chart has none of its points
  std::shared_ptr<const CavityLines> lines;  // null: no cavity is chosen
  std::vector<TracedSeries> chosen;          // cavities of `lines` that are plotted
  int chart_quantity = -1;

  // The part of the chart that is of curves. It serves as long as cavities keep their numbers.
  struct Whole {
    CavityChart chart;
    std::shared_ptr<const void> curves;
    std::vector<TracedSeries> chosen;
    int quantity = -1;
  } whole;

  ShownLives lives;
};

}  // namespace alphascope
