// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of curves share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/cavities/cavity_chart.hpp"

namespace alphascope {

enum class CurveAxis;
enum class DerivedState : std::uint8_t;
struct CavityCurves;
struct CavityLines;
struct CavityTrace;
struct CurveLinks;
struct CurveState;
struct PanelContext;
template <class T>
struct Definition;
template <class T>
struct Derived;

// --- curve_following.cpp

// The choices of the user.
CurveAxis curve_axis(const CurveState& memory);
CurveQuantity curve_quantity(const CurveState& memory);
const Definition<CavityCurves>& curves_wanted(const CurveState& memory);
// Replaces the chart as soon as results for a newer one are there. Returns whether the chart
// belongs to the picture.
bool follow_curves(PanelContext& ctx, CurveState& memory, const Derived<CavityCurves>& curves);

// --- curve_charting.cpp

// The results that there are for the present choices.
struct CurveResults {
  std::shared_ptr<const CavityCurves> curves;  // null: not known yet
  std::shared_ptr<const CurveLinks> links;
  bool links_follow = false;  // they are on their way
  std::shared_ptr<const CavityTrace> trace;
  std::shared_ptr<const CavityLines> lines;  // null: no cavity is chosen
  std::vector<std::size_t> rows;             // of the chosen cavities
  std::vector<TracedSeries> chosen;
};

// A series for each row. Rows for which there are no colours left are dropped.
std::vector<TracedSeries> series_of_rows(const CavityLines& lines, std::vector<std::size_t>& rows);
bool same_numbers(const std::vector<TracedSeries>& a, const std::vector<TracedSeries>& b);
// Makes CurveState::whole, or keeps it if it is of the same cavities. Returns whether there is one.
bool follow_whole_chart(CurveState& memory, const CurveResults& now);
// Makes the chart. `has_whole`: CurveState::whole is a part of it.
void make_curves_chart(CurveState& memory, const CurveResults& now, bool has_whole);

// --- curve_asking.cpp

// Returns whether the curves may be computed. Curves that take long wait until the user starts
// them.
bool curves_are_asked_for(PanelContext& ctx, CurveState& memory);
// Draws a button that cancels the computation, or starts it again.
void curves_cancel_button(PanelContext& ctx, const CurveState& memory,
                          const Derived<CavityCurves>& curves);
// Waiting or running.
bool is_on_its_way(DerivedState state);
// Says why there are no curves yet, or not all of them.
std::string curves_waiting_text(const PanelContext& ctx, const CurveState& memory,
                                const Derived<CavityCurves>& curves);

// --- curve_drawing.cpp

// Returns the present setting on this axis.
double shown_on_axis(const PanelContext& ctx, CurveAxis axis);
// Draws the plot in the remaining room. A click or drag sets alpha, solvent radius or model.
void draw_curves_plot(PanelContext& ctx, const CurveState& memory);

// --- curve_saving.cpp

// Draws buttons that copy and save the chart. `current`: it belongs to the picture.
void curves_save_buttons(PanelContext& ctx, const CurveState& memory, bool current);

}  // namespace alphascope
