// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Steps”: how an engine finds the simplices of one ball. It lists the steps, explains the
// present one in sentences and numbers, and draws it in the view.
#include <algorithm>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "core/document/explain/steps_results.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void forget(StepsState& memory) {
  memory.shown = nullptr;
  memory.balls = nullptr;
  memory.current = memory.playing = false;
  memory.drawn = {};
}

void draw_steps(PanelContext& ctx) {
  const float all = ImGui::GetContentRegionAvail().x, gap = ctx.px(14);
  const float list = std::min(ctx.px(290), 0.31f * all), side = std::min(ctx.px(250), 0.26f * all);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ctx.state.steps.current ? 1.0f : 0.55f);
  draw_step_list(ctx, list);
  ImGui::SameLine(0, gap);
  draw_step_text(ctx, all - list - side - 2 * gap);
  ImGui::SameLine(0, gap);
  draw_step_counts(ctx, side);
  ImGui::PopStyleVar();
}

// Draws a sentence in the place of the steps, and a button that takes a ball.
void draw_nothing(PanelContext& ctx, const std::string& why) {
  forget(ctx.state.steps);
  muted_wrapped(ctx, why);
  record(ctx, "steps.nothing");
  const CommandSpec* middle = ctx.commands.find("steps.middle");
  if (middle == nullptr || !middle->reason_against().empty()) return;
  if (button(ctx, "steps.middle", "Take a ball in the middle")) run_command(ctx, *middle);
}

void draw_steps_page(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  draw_steps_controls(ctx);
  if (!ctx.inputs.balls || !ctx.inputs.atoms) {
    return draw_nothing(ctx, "Open a molecule: the steps are those of one of its balls.");
  }
  if (ctx.inputs.balls->size() == 0) {
    return draw_nothing(ctx, "There are no balls, so there is nothing to find.");
  }
  const SelectedBall asked = selected_ball(ctx.state.settings.selection, *ctx.inputs.atoms);
  if (!asked.ball) return draw_nothing(ctx, asked.why_not);
  const Derived<ExplainedSteps> found = want_steps(ctx, *asked.ball);
  take_steps(ctx, found);
  if (memory.shown && memory.balls == ctx.inputs.balls) {
    look_when_asked(ctx);
    draw_step_in_view(ctx);
    return draw_steps(ctx);
  }
  muted_wrapped(ctx, found.state == DerivedState::failed || found.state == DerivedState::no_room
                         ? "There are no steps. " + found.why
                         : "Computing the steps of the ball…");
  record(ctx, "steps.waiting");
}

}  // namespace

std::unique_ptr<Panel> steps_panel() {
  return panel_of(draw_steps_page);
}

}  // namespace alphascope
