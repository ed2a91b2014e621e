// The figures of the thesis' chapter 4, from the suite's rows.
#pragma once

#include <vector>

#include "app/bench/thesis_suite.hpp"
#include "core/chart/chart.hpp"

namespace alphascope {

// In the thesis' order: speed-up (Figure 4.1), improvement over alpha (4.2 to 4.4; over CGAL, where
// the thesis had gReg3d), alpha up to which CGAL is beaten (4.5), share of the full triangulation
// (4.6), ablation (4.7), shares of the stages (4.8). One of a kind for each engine where it has
// one. Charts without any value are left out.
std::vector<Chart> thesis_charts(const ThesisReport& report);

}  // namespace alphascope
