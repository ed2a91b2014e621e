// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of cavities as a chart, for the window's plot and for tables.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/chart/chart.hpp"

namespace alphascope {

enum class CurveAxis;
enum class CurveNumbers;
struct CavityCurves;
struct CavityTrace;
struct CurveLinks;

// SA volume (Å³), SA area (Å²), exact volume (Å³; only on curves that have it), number of mouths.
enum class CurveQuantity { volume, area, exact_volume, mouths };
CurveNumbers numbers_for(CurveQuantity quantity);

// A cavity of the table that is plotted.
struct ChartedCavity {
  std::uint32_t cavity = 0;  // index in found.cavities
  std::string name;          // "pocket 4"
};

// A sample at which a cavity splits, or is joined with another.
struct CurveMark {
  std::size_t series = 0, sample = 0;
  std::string text;  // "Between 1.3 and 1.4 Å it splits into 3 cavities."
};

struct CavityChart {
  Chart chart;  // lines; a gap where the cavity does not exist
  std::vector<CurveMark> marks;
  std::vector<bool> traced;  // for each sample: it is a point of a trace; empty: none is
};

// Labels with units: "SA volume (Å³)", "solvent radius (Å)".
std::string quantity_label(CurveQuantity quantity);
std::string quantity_unit(CurveQuantity quantity);  // may be empty
std::string axis_label(CurveAxis axis);
// A position on the axis, without unit: "1.4"; for models the number, counted from 1.
std::string axis_text(CurveAxis axis, double at);

// A series for each chosen cavity, at the samples where `links` identifies it.
CavityChart chart_of_cavities(const CavityCurves& curves, CurveQuantity quantity,
                              const CurveLinks& links, const std::vector<ChartedCavity>& chosen);
// Sums over all voids, and over all pockets.
CavityChart chart_of_totals(const CavityCurves& curves, CurveQuantity quantity);

// The same of the points of a trace (core/cavity_identity/cavity_trace.hpp). It has no exact
// volumes, so a chart of these is empty.
struct TracedSeries {
  std::uint32_t number = 0;  // of CavityNumbers
  std::string name;
};
CavityChart chart_of_trace(const CavityTrace& trace, CurveQuantity quantity,
                           const std::vector<TracedSeries>& chosen);
CavityChart totals_of_trace(const CavityTrace& trace, CurveQuantity quantity);
// The samples of both charts, which must have the same series. Where both have a sample, that of
// `whole` counts.
CavityChart with_trace(const CavityChart& whole, const CavityChart& trace);

// A CSV table with all digits: x, then each series; empty in a gap. `comments` come first, each
// after "# ".
std::string chart_csv(const Chart& chart, const std::vector<std::string>& comments);

}  // namespace alphascope
