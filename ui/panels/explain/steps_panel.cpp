// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Steps”: how an engine finds the simplices of one ball. It lists the steps, explains the
// present one in sentences and numbers, and draws it in the view.
#include <algorithm>
#include <utility>

#include "core/document/commands/commands.hpp"
#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/shortest_number.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/steps_layer.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/panels/view_state.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"

namespace alphascope {
namespace {

// --- results

StepsRequest asked_steps(const PanelContext& ctx, BallIndex ball) {
  const StepsState& memory = ctx.state.steps;
  StepsRequest asked{ball, memory.engine, ctx.state.settings.request.tuples};
  asked.options.edge_optimisation = memory.edge_optimisation;
  asked.options.alpha_optimisation = memory.alpha_optimisation;
  return asked;
}

// Asks the store for the steps of this ball. If a job for an earlier question has run for long,
// cancels it.
Derived<ExplainedSteps> want_steps(PanelContext& ctx, BallIndex ball) {
  constexpr double kLong = 0.15;  // seconds; an earlier answer that is nearly ready is better shown
  StepsState& memory = ctx.state.steps;
  const Definition<ExplainedSteps> definition = explained_steps(asked_steps(ctx, ball));
  const Key key = definition.key(ctx.inputs);
  if (!(key == memory.asked)) {
    if (!memory.current && ImGui::GetTime() - memory.asked_at > kLong) ctx.store.cancel(kStepsId);
    memory.asked = key;
    memory.asked_at = ImGui::GetTime();
  }
  return ctx.store.want(definition, ctx.inputs);
}

void forget(StepsState& memory) {
  memory.shown = nullptr;
  memory.balls = nullptr;
  memory.current = memory.playing = false;
  memory.drawn = {};
}

// Goes to the step that was asked for, by number or name, before the steps were known.
void go_where_asked(PanelContext& ctx, StepsState& memory) {
  if (memory.go_to.empty()) return;
  const std::string asked = std::exchange(memory.go_to, {});
  const auto found = step_number(memory.shown->steps, asked);
  if (found) return memory.show(*found);
  ctx.state.notice = "There is no step “" + asked + "” here.";
}

void take_steps(PanelContext& ctx, const Derived<ExplainedSteps>& found) {
  StepsState& memory = ctx.state.steps;
  memory.current = found.ready();
  if (!memory.current) return;
  if (memory.shown != found.value || memory.balls != ctx.inputs.balls) {
    memory.shown = found.value;
    memory.balls = ctx.inputs.balls;
    memory.drawn = {};
  }
  go_where_asked(ctx, memory);
}

// --- drawing in the view

std::string name_of_ball(const PanelContext& ctx, BallIndex ball) {
  return atom_text(*ctx.inputs.atoms, ball);
}

void draw_step_in_view(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  StepsState::Drawn& drawn = memory.drawn;
  const bool light = ctx.state.theme() == Theme::light;
  if (drawn.layers.empty() || drawn.step != memory.at() || drawn.light != light) {
    const BallSteps& steps = memory.shown->steps;
    const StepScene scene{steps, steps.steps[memory.at()], name_of_ball(ctx, steps.ball),
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

// --- the page

// Draws the title, such as "Kernel II: 3 of 39 valid", the ball, the sentences, and how much more
// work there is.
void draw_text(PanelContext& ctx, float width) {
  const StepsState& memory = ctx.state.steps;
  const ExplainedSteps& told = *memory.shown;
  const StepText& text = told.texts[memory.at()];
  ImGui::BeginChild("text", {width, 0}, false);
  strong_text(ctx, text.title + ": " + with_minus_signs(text.brief));
  record(ctx, "steps.title");
  muted_text(ctx,
             fitted_text(name_of_ball(ctx, told.steps.ball) + " at α = " +
                             with_minus_signs(shortest_number(
                                 told.steps.lattice.alpha_angstrom2(told.steps.alpha_on_lattice))) +
                             " Å²",
                         ImGui::GetContentRegionAvail().x));
  wrapped_text(with_minus_signs(text.text));
  record(ctx, "steps.text");
  if (!told.growth.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.warning));
    wrapped_text(told.growth);
    ImGui::PopStyleColor();
    record(ctx, "steps.growth");
  }
  for (const std::string& note : steps_notes(ctx)) muted_wrapped(ctx, note);
  ImGui::EndChild();
}

void draw_steps(PanelContext& ctx) {
  const float all = ImGui::GetContentRegionAvail().x, gap = ctx.px(14);
  const float list = std::min(ctx.px(290), 0.31f * all), side = std::min(ctx.px(250), 0.26f * all);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ctx.state.steps.current ? 1.0f : 0.55f);
  draw_step_list(ctx, list);
  ImGui::SameLine(0, gap);
  draw_text(ctx, all - list - side - 2 * gap);
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
