// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the triangulation from the store, without asking for it.
#include "ui/panels/complex/shown_triangulation.hpp"

#include "core/complex/triangulation.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::shared_ptr<const TriangulationReport> shown_triangulation(PanelContext& ctx) {
  if (!ctx.inputs.balls || ctx.inputs.balls != ctx.state.shown_balls()) return nullptr;
  const auto triangulation = ctx.store.have(whole_triangulation(), ctx.inputs);
  return triangulation ? triangulation->report : nullptr;
}

}  // namespace alphascope
