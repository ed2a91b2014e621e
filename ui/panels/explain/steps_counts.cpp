// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of the colours of a step, and its numbers as a table.
#include <algorithm>
#include <cstdint>
#include <string>

#include "core/document/explain/step_names.hpp"
#include "core/document/explain/steps_results.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/explain/steps_layer.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void legend_line(PanelContext& ctx, StepMark mark, const std::string& text, bool box) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetFontSize() * 0.7f, down = (ImGui::GetTextLineHeight() - side) / 2;
  const ImVec2 low{at.x, at.y + down}, high{at.x + side, at.y + down + side};
  const ImU32 colour = to_u32(step_colour(mark, ctx.state.theme()));
  if (box) {
    ImGui::GetWindowDrawList()->AddRect(low, high, colour, 0, 0, ctx.px(1.5f));
  } else {
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, colour);
  }
  ImGui::Dummy({side, ImGui::GetTextLineHeight()});
  ImGui::SameLine(0, ctx.px(6));
  ImGui::TextUnformatted(fitted_text(text, ImGui::GetContentRegionAvail().x).c_str());
}

std::size_t listed(const MarkedSimplices& m) {
  return m.vertices.size() + m.edges.size() + m.triangles.size() + m.tetrahedra.size();
}

// Draws the legend in the order of the marks. Each mark has one line.
void legend(PanelContext& ctx, const Step& step) {
  legend_line(ctx, StepMark::chosen, step_mark_name(step.kind, StepMark::chosen), false);
  for (const StepMark mark : {StepMark::kept, StepMark::undecided, StepMark::dropped}) {
    std::uint64_t number = 0, left_out = 0;
    for (const MarkedSimplices& marked : step.marks) {
      if (marked.mark != mark) continue;
      number += listed(marked) + marked.left_out;
      left_out += marked.left_out;
    }
    if (number == 0) continue;
    std::string text = std::string(step_mark_name(step.kind, mark)) + ": " + grouped(number);
    if (left_out > 0) text += ", " + grouped(number - left_out) + " drawn";
    legend_line(ctx, mark, text, false);
  }
  for (const StepBox& box : step.boxes) {
    legend_line(ctx, box.mark, step_box_name(step.kind, box.mark), true);
  }
  for (const StepSphere& sphere : step.spheres) {
    legend_line(ctx, sphere.mark, "its grown ball", true);
  }
  if (!step.segments.empty()) {
    legend_line(
        ctx, step.segments.front().mark,
        "rods: " + grouped(step.segments.size()) + " dual edges, cut to the parts that are left",
        false);
  }
  record(ctx, "steps.legend");
}

struct CountColumns {
  bool here = false, optimised = false;
};

void count_row(PanelContext& ctx, const StepCount& count, const CountColumns& columns) {
  const StepsState& memory = ctx.state.steps;
  const Step& step = memory.shown->steps.steps[memory.at()];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(step_count_name(count.id).c_str());
  number_cell(grouped(count.all));
  record(ctx, ("steps.count." + std::string(count.id)).c_str());
  if (columns.here) number_cell(count.here == count.all ? "" : grouped(count.here));
  if (!columns.optimised) return;
  const StepCount* const before = memory.shown->optimised_count(step, count.id);
  number_cell(before == nullptr ? "–" : grouped(before->all));
}

void header_cell(PanelContext& ctx, const char* text, const char* help) {
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  right_text(text);
  ImGui::PopStyleColor();
  tooltip(ctx, help);
}

void count_table(PanelContext& ctx, const Step& step) {
  CountColumns columns;
  columns.here = std::any_of(step.counts.begin(), step.counts.end(),
                             [](const StepCount& count) { return count.here != count.all; });
  columns.optimised = ctx.state.steps.shown->optimised.has_value();
  const int numbers = 1 + int{columns.here} + int{columns.optimised};
  if (!ImGui::BeginTable("counts", 1 + numbers, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
  if (numbers > 1) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    header_cell(ctx, "all", "Number of all simplices that contain the ball.");
    if (columns.here) {
      header_cell(ctx, "here",
                  "Number of tuples that are made at this ball. Each tuple is made once, at the "
                  "ball that comes first in the grid.");
    }
    if (columns.optimised) header_cell(ctx, "both on", "Number with both optimisations on.");
  }
  for (const StepCount& count : step.counts) count_row(ctx, count, columns);
  ImGui::EndTable();
}

}  // namespace

void draw_step_counts(PanelContext& ctx, float width) {
  StepsState& memory = ctx.state.steps;
  ImGui::BeginChild("counts", {width, 0}, false);
  checkbox(ctx, "steps.marks", "Draw", memory.marks);
  tooltip(ctx, "Draws the step in the picture, and fades balls and complex.");
  constexpr const char* kLook = "Look at it";
  same_line_where_it_fits(button_width(kLook), ctx.px(10));
  if (button(ctx, "steps.look", kLook)) memory.look = true;
  tooltip(ctx, "Moves the ball and its neighbours to the middle of the view.");
  ImGui::PushFont(ctx.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ctx.px(6), ctx.px(2)});
  const Step& step = memory.shown->steps.steps[memory.at()];
  if (memory.marks) legend(ctx, step);
  count_table(ctx, step);
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::EndChild();
}

}  // namespace alphascope
