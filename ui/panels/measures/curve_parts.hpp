// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of curves share.
#pragma once

#include <string>

namespace alphascope {

enum class CurveAxis;
enum class CurveQuantity;
struct CavityCurves;
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

// --- curve_asking.cpp

// Returns whether the curves may be computed. Curves that take long wait until the user starts
// them.
bool curves_are_asked_for(PanelContext& ctx, CurveState& memory);
// Draws a button that cancels the computation, or starts it again.
void curves_cancel_button(PanelContext& ctx, const CurveState& memory,
                          const Derived<CavityCurves>& curves);
// Says why there are no curves yet.
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
