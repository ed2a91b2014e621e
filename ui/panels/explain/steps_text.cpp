// SPDX-License-Identifier: GPL-3.0-or-later
// The present step in sentences.
#include <string>
#include <vector>

#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/shortest_number.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void draw_step_text(PanelContext& ctx, float width) {
  const StepsState& memory = ctx.state.steps;
  const ExplainedSteps& told = *memory.shown;
  const StepText& text = told.texts[memory.at()];
  ImGui::BeginChild("text", {width, 0}, false);
  strong_text(ctx, text.title + ": " + with_minus_signs(text.brief));
  record(ctx, "steps.title");
  muted_text(ctx,
             fitted_text(atom_text(*ctx.inputs.atoms, told.steps.ball) + " at α = " +
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
  muted_wrapped(ctx, with_minus_signs(told.saturation_text));
  record(ctx, "steps.saturation");
  for (const std::string& note : steps_notes(ctx)) muted_wrapped(ctx, note);
  ImGui::EndChild();
}

}  // namespace alphascope
