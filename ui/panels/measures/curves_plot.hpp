// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of the page of curves as a plot.
#pragma once

#include <cstddef>
#include <string>

namespace alphascope {

struct CurveState;
struct Plot;

// `shown` is the present setting on the x axis.
Plot curves_plot(const CurveState& memory, double shown);
// The values of all curves at a sample, for the tooltip.
std::string curves_text(const CurveState& memory, std::size_t sample);

}  // namespace alphascope
