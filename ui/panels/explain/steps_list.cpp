// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the steps of a ball.
#include <string>
#include <utility>

#include "core/document/explain/steps_results.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
void draw_step_list(PanelContext& ctx, float width) {
  StepsState& memory = ctx.state.steps;
  ImGui::PushFont(ctx.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ctx.px(6), ctx.px(2)});
  ImGui::BeginChild("list", {width, 0}, false);
  for (std::size_t n = 0; n < memory.count(); ++n) {
    const StepText& text = memory.shown->texts[n];
    const std::string name = "steps.step." + std::to_string(n + 1);
    const float right = ImGui::GetContentRegionAvail().x - ctx.px(4),
                brief = ImGui::CalcTextSize(text.brief.c_str()).x;
    const std::string title = std::to_string(n + 1) + "  " + text.title;
    ImGui::PushID(static_cast<int>(n));
    if (ImGui::Selectable(fitted_text(title, right - brief - ctx.px(8)).c_str(),
                          n == memory.at())) {
      memory.show(n);
      memory.playing = false;
    }
    record(ctx, name.c_str());
    tooltip(ctx, (text.title + ": " + text.brief).c_str());
    if (n == memory.at() && std::exchange(memory.scroll_to, false)) ImGui::SetScrollHereY();
    ImGui::SameLine(right - brief);
    muted_text(ctx, text.brief);
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace alphascope
