// What the page of curves remembers between frames. Plain data.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/cavities/cavity_bars.hpp"
#include "core/document/cavities/cavity_chart.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/molecule/atom_colours.hpp"

namespace alphascope {

struct CurveMemory {
  static constexpr int kLives = 3;  // a quantity that is none of those of curves

  int axis = 1;          // a CurveAxis
  int quantity = 0;      // a CurveQuantity, or kLives
  std::string molecule;  // SHA-256 of its file
  // Molecules whose curves take long are asked about: for which axis and quantity they were asked
  // for; -1: none.
  std::pair<int, int> asked_for{-1, -1};

  // What is plotted, and of what it was made.
  CavityChart chart;
  std::vector<Rgb8> colours;  // of each series
  CurveAxis chart_axis = CurveAxis::alpha;
  std::shared_ptr<const void> curves, links;
  std::shared_ptr<const CavityLines> lines;  // null: nothing is chosen
  std::vector<std::size_t> rows;             // of them, those that are plotted
  int chart_quantity = -1;

  // The longest lives, of what they were made, and which row of the table each is now.
  struct Lives {
    static constexpr std::size_t kNoRow = ~std::size_t{0};
    CavityBars bars;
    std::shared_ptr<const CavityLives> of;
    double from_angstrom2 = 0;
    std::shared_ptr<const CavityLines> lines;
    std::vector<std::size_t> rows;  // of each bar; kNoRow: it is not there
  } lives;
};

}  // namespace alphascope
