// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons that move between steps, and the choice of engine and optimisations.
#include <string>

#include "core/document/commands/commands.hpp"
#include "core/document/explain/steps_results.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Draws a button that runs a command. It is greyed if the command cannot run.
void move_button(PanelContext& ctx, const char* id, const char* label) {
  const CommandSpec* const spec = ctx.commands.find(id);
  if (spec == nullptr) return;
  const std::string against = spec->reason_against();
  ImGui::BeginDisabled(!against.empty());
  if (button(ctx, id, label, {ctx.px(50), 0})) run_command(ctx, *spec);
  ImGui::EndDisabled();
  const std::string keys = spec->shortcuts_text();
  tooltip(ctx, (spec->help + (keys.empty() ? "." : " (" + keys + ").")).c_str());
}

void engine_choice(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  if (steps_engines().size() < 2) return;
  constexpr float kWidth = 170;
  same_line_where_it_fits(ctx.px(kWidth), ctx.px(16));
  ImGui::SetNextItemWidth(ctx.px(kWidth));
  if (list_field(ctx, "steps.engine", spec_of(memory.engine).title)) {
    for (const StepsEngineSpec& spec : steps_engines()) {
      const char* const id = steps_engine_id(spec.engine);
      if (ImGui::Selectable(spec.title, spec.engine == memory.engine)) {
        ctx.commands.run("steps.engine", {id});
      }
      record(ctx, (std::string("steps.engine.") + id).c_str());
    }
    ImGui::EndCombo();
  }
  record(ctx, "steps.engine");
  tooltip(ctx,
          "Engine whose steps are shown. It may differ from the engine that computed the complex.");
}

// Draws a check box behind the last item, or below it if there is no room.
void optimisation(PanelContext& ctx, const char* name, const char* label, bool& value) {
  same_line_where_it_fits(checkbox_width(label), ctx.px(12));
  checkbox(ctx, name, label, value);
  const CommandSpec* const spec = ctx.commands.find(name);
  if (spec != nullptr) tooltip(ctx, (spec->help + ".").c_str());
}

}  // namespace

void draw_steps_controls(PanelContext& ctx) {
  StepsState& memory = ctx.state.steps;
  const float gap = ctx.px(4);
  move_button(ctx, "steps.first", "First");
  ImGui::SameLine(0, gap);
  move_button(ctx, "steps.back", "Back");
  ImGui::SameLine(0, gap);
  move_button(ctx, "steps.play", memory.playing ? "Pause" : "Play");
  ImGui::SameLine(0, gap);
  move_button(ctx, "steps.next", "Next");
  ImGui::SameLine(0, gap);
  move_button(ctx, "steps.last", "Last");
  engine_choice(ctx);
  if (spec_of(memory.engine).has_optimisations) {
    optimisation(ctx, "steps.edge_optimisation", "Edge optimisation", memory.edge_optimisation);
    optimisation(ctx, "steps.alpha_optimisation", "Alpha optimisation", memory.alpha_optimisation);
  }
}

}  // namespace alphascope
