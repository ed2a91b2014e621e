// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of tables: numbers at the right, and buttons in rows.
#include "ui/widgets/table_cells.hpp"

#include <imgui.h>

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

float title_width(const char* title) {
  constexpr float kArrow = 0.65f;  // of the font's size, as ImGui draws it
  return ImGui::CalcTextSize(title).x + kArrow * ImGui::GetFontSize() +
         ImGui::GetStyle().FramePadding.x;
}

void right_text(const std::string& text) {
  const float right = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, right));
  ImGui::TextUnformatted(text.c_str());
}

bool row_button(PanelContext& ctx, const char* name, const char* label, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const bool clicked = button(ctx, name, label, {ctx.px(width), 0}, ButtonKind::quiet);
  ImGui::PopStyleVar();
  return clicked;
}

void number_cell(const std::string& text) {
  ImGui::TableNextColumn();
  right_text(text);
}

}  // namespace alphascope
