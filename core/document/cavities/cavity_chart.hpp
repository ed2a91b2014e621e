// Curves of cavities as a chart: what the window plots, and what a table of them says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/cavity_identity/cavity_curves.hpp"
#include "core/chart/chart.hpp"

namespace alphascope {

// SA volume, Å³; SA area, Å²; exact volume, Å³, of curves that have it.
enum class CurveQuantity { volume, area, exact_volume };
CurveNumbers numbers_for(CurveQuantity quantity);

// A cavity of a table to be plotted.
struct ChartedCavity {
  std::uint32_t cavity = 0;  // of found.cavities
  std::string name;          // "pocket 4"
};

// Where a cavity splits, or is joined with another one.
struct CurveMark {
  std::size_t series = 0, sample = 0;
  std::string text;  // "Between 1.3 and 1.4 Å it splits into 3 cavities."
};

struct CavityChart {
  Chart chart;  // lines; a gap where the cavity is not there
  std::vector<CurveMark> marks;
};

// With unit: "SA volume (Å³)", "solvent radius (Å)".
std::string quantity_label(CurveQuantity quantity);
std::string axis_label(CurveAxis axis);
// A place on an axis, without unit: "1.4"; a model's number, counted from 1.
std::string axis_text(CurveAxis axis, double at);

// Of each chosen cavity, where `links` says that it is on the curves.
CavityChart chart_of_cavities(const CavityCurves& curves, CurveQuantity quantity,
                              const CurveLinks& links, const std::vector<ChartedCavity>& chosen);
// All voids together, and all pockets.
CavityChart chart_of_totals(const CavityCurves& curves, CurveQuantity quantity);

// Lines of commas: x, then each series; nothing in a gap. All digits. `comments` stand above, with
// "# " before each.
std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments);

}  // namespace alphascope
