// SPDX-License-Identifier: GPL-3.0-or-later
// Asks for the steps of a ball, and takes them when they are there.
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "core/document/explain/steps_results.hpp"
#include "core/document/settings/request.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

StepsRequest asked_steps(const PanelContext& ctx, BallIndex ball) {
  const StepsState& memory = ctx.state.steps;
  StepsRequest asked{ball, memory.engine, ctx.state.settings.request.tuples};
  asked.options.edge_optimisation = memory.edge_optimisation;
  asked.options.alpha_optimisation = memory.alpha_optimisation;
  return asked;
}

// Goes to the step that was asked for, by number or name, before the steps were known.
void go_where_asked(PanelContext& ctx, StepsState& memory) {
  if (memory.go_to.empty()) return;
  const std::string asked = std::exchange(memory.go_to, {});
  const auto found = step_number(memory.shown->steps, asked);
  if (found) return memory.show(*found);
  ctx.state.refuse_late("There is no step “" + asked + "” here.");
}

}  // namespace

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

std::optional<std::size_t> step_number(const BallSteps& steps, const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data(), end, number).ptr == end && number > 0) {
    return number <= steps.steps.size() ? std::optional(number - 1) : std::nullopt;
  }
  for (std::size_t n = 0; n < steps.steps.size(); ++n) {
    if (text == step_id(steps.steps[n].kind)) return n;
  }
  return std::nullopt;
}

}  // namespace alphascope
