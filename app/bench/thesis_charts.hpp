// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the thesis' chapter 4, made from the suite's rows.
#pragma once

#include <vector>

#include "app/bench/thesis_suite.hpp"
#include "core/chart/chart.hpp"

namespace alphascope {

// Charts in the thesis' order. Figure 4.1: speed-up. 4.2 to 4.4: improvement over CGAL (in the
// thesis: over gReg3d) against alpha. 4.5: largest alpha at which CGAL is beaten. 4.6: share of the
// full triangulation. 4.7: ablation. 4.8: shares of the stages. Some figures have one chart for
// each engine. Charts without values are left out.
std::vector<Chart> thesis_charts(const ThesisReport& report);

}  // namespace alphascope
