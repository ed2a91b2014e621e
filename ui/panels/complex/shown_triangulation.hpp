// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of the balls on screen.
#pragma once

#include <memory>

namespace alphascope {

struct PanelContext;
struct TriangulationReport;

// Says how the triangulation of all balls was made, on which cavities and large alphas rest. Null
// if it is not there.
std::shared_ptr<const TriangulationReport> shown_triangulation(PanelContext& ctx);

}  // namespace alphascope
