// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Why?”: sentences on why the selected simplex is in the complex or not. Buttons lead to
// the balls that decide, and the view shows the orthosphere.
#include "core/document/explain/explanation_results.hpp"
#include "core/document/explain/explanation_text.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/explain/why_layer.hpp"
#include "ui/panels/explain/why_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Draws the explanation in the view. The layer belongs to the balls on screen.
void draw_marks_of(PanelContext& ctx, WhyState& memory) {
  if (!memory.layer) {
    memory.layer = make_why_layer(memory.shown->explanation, memory.balls, ++memory.layers_made);
  }
  if (ctx.state.window.why_marks) ctx.state.layers.push_back(memory.layer);
}

void take_answer(WhyState& memory, const Derived<ExplainedSimplex>& found, const Inputs& inputs) {
  if (memory.shown == found.value && memory.balls == inputs.balls) return;
  memory.shown = found.value;
  memory.balls = inputs.balls;
  memory.layer = nullptr;
}

void go_to(PanelContext& ctx, const std::vector<BallIndex>& balls) {
  ViewState& s = ctx.state;
  s.settings.selection.clear();
  s.settings.selection.items = RefSet({ctx.inputs.atoms->reference(balls)});
  ctx.calls.view.zoom_to_selection();
}

void draw_line(PanelContext& ctx, const ExplanationLine& line, std::size_t number, bool current) {
  constexpr float kHeading = 110, kButton = 64;
  const float left = ImGui::GetCursorPosX();
  const float top = ImGui::GetCursorPosY();
  const std::string name = "why.line." + std::to_string(number);
  muted_text(ctx, line.heading);
  ImGui::SetCursorPos({left + ctx.px(kHeading), top});
  const float width = ImGui::GetContentRegionAvail().x - ctx.px(kButton + 12);
  const std::string text = broken_lines(with_minus_signs(line.text), width);
  if (current) {
    ImGui::TextUnformatted(text.c_str());
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
  }
  record(ctx, name.c_str());
  const float below = ImGui::GetCursorPosY();
  if (line.about.empty() || !current) return;
  ImGui::SetCursorPos({left + ctx.px(kHeading) + width + ctx.px(8), top - ctx.px(2)});
  const std::string go = "why.go." + std::to_string(number);
  if (button(ctx, go.c_str(), "Go to", {ctx.px(kButton), 0}, ButtonKind::quiet)) {
    go_to(ctx, line.about);
  }
  tooltip(ctx, line.about.size() == 1 ? "Selects this ball and moves the view to it."
                                      : "Selects this simplex and moves the view to it.");
  ImGui::SetCursorPosY(std::max(below, ImGui::GetCursorPosY()));
}

void draw_answer(PanelContext& ctx, const WhyState& memory, bool current) {
  ImGui::BeginChild("why", {0, 0}, false);
  const auto& lines = memory.shown->lines;
  for (std::size_t n = 0; n < lines.size(); ++n) draw_line(ctx, lines[n], n, current);
  ImGui::EndChild();
}

void draw_why(PanelContext& ctx, WhyState& memory) {
  checkbox(ctx, "why.marks", "Show in the picture", ctx.state.window.why_marks);
  tooltip(ctx,
          "Draws the orthosphere (yellow wire, unless it is imaginary) and the nearest other "
          "ball (red wire). Draws the dual edge, facet or cell (green): the part of space that "
          "the balls share.");
  if (!ctx.inputs.balls || !ctx.inputs.atoms) {
    memory.shown = nullptr;
    return muted_wrapped(ctx, "Open a molecule: this page explains the selected atom or simplex.");
  }
  const SelectedSimplex asked =
      selected_simplex(ctx.state.settings.selection.items, *ctx.inputs.atoms);
  if (!asked.why_not.empty()) {
    memory.shown = nullptr;
    muted_wrapped(ctx, asked.why_not);
    return record(ctx, "why.nothing");
  }
  const auto found = ctx.store.want(explained_simplex(asked.balls), ctx.inputs);
  if (found.ready()) take_answer(memory, found, ctx.inputs);
  if (!found.value && !found.why.empty()) return muted_wrapped(ctx, found.why);
  if (!memory.shown || memory.balls != ctx.inputs.balls) return;
  draw_marks_of(ctx, memory);
  draw_answer(ctx, memory, found.ready());
}

}  // namespace

std::unique_ptr<Panel> why_panel() {
  return panel_of(draw_why);
}

}  // namespace alphascope
