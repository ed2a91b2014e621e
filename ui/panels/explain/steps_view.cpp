// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the present step in the view, and moves the view to its ball.
#include <string>
#include <utility>
#include <vector>

#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/calls.hpp"
#include "ui/panels/explain/steps_layer.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void draw_step_in_view(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  StepsState::Drawn& drawn = memory.drawn;
  const bool light = ctx.state.theme() == Theme::light;
  if (drawn.layers.empty() || drawn.step != memory.at() || drawn.light != light) {
    const BallSteps& steps = memory.shown->steps;
    const StepScene scene{steps, steps.steps[memory.at()], atom_text(*ctx.inputs.atoms, steps.ball),
                          memory.balls, ctx.state.theme()};
    drawn = {memory.at(), light, make_steps_layers(scene, ++memory.layers_made)};
  }
  if (!memory.marks) return;
  ctx.state.layers.insert(ctx.state.layers.end(), drawn.layers.begin(), drawn.layers.end());
}

void look_when_asked(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  if (!memory.current || !std::exchange(memory.look, false)) return;
  std::vector<Ref> all{ctx.inputs.atoms->atom(memory.shown->steps.ball)};
  if (const Step* cube = memory.shown->steps.find(StepKind::cube)) {
    for (const MarkedSimplices& marked : cube->marks) {
      if (marked.mark != StepMark::kept) continue;
      for (const auto& v : marked.vertices) all.push_back(ctx.inputs.atoms->atom(v[0]));
    }
  }
  ctx.calls.view.zoom_to(RefSet(std::move(all)));
}

}  // namespace alphascope
