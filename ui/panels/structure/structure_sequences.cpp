// SPDX-License-Identifier: GPL-3.0-or-later
// The sequences at the right of the page Structure. Only lines in sight are drawn.
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/document/reference/reference.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/rgb8.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Letters of one chain that stand in one line.
void sequence_line(StructurePage& page, const ResidueBranch& branch, std::size_t begin,
                   std::size_t end, ImVec2 cell) {
  PanelContext& ctx = page.ctx;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ResidueRow& first = page.rows.residues[begin];
  const std::string number =
      std::to_string(page.atoms.molecule().atoms[first.first].residue_number);
  const std::string label = (begin == branch.begin ? branch.title + "  " : "") + number;
  const float label_width = ctx.px(110);
  ImGui::PushFont(ctx.fonts.small);
  const float width = ImGui::CalcTextSize(label.c_str()).x;
  draw->AddText({corner.x + label_width - ctx.px(8) - width, corner.y},
                to_u32(ctx.palette.text_muted), label.c_str());
  ImGui::PopFont();
  const float left = corner.x + label_width;
  const auto letters = static_cast<float>(end - begin);
  ImGui::SetCursorScreenPos({left, corner.y});
  const bool clicked = ImGui::InvisibleButton(("##line" + std::to_string(begin)).c_str(),
                                              {letters * cell.x, cell.y});
  record(ctx, ("structure.sequence." + std::to_string(begin + 1)).c_str());
  if (ImGui::IsItemHovered() || clicked || ImGui::IsItemClicked(1)) {
    const float at = (ImGui::GetMousePos().x - left) / cell.x;
    const auto letter = static_cast<std::size_t>(std::clamp(at, 0.0F, letters - 1));
    const std::size_t row = begin + letter;
    take_mouse(page, row, row + 1, clicked);
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s, %s",
                        residue_title(page.atoms.molecule(), page.rows.residues[row]).c_str(),
                        branch.title.c_str());
    }
  }
  ImGui::PushFont(ctx.fonts.mono);
  for (std::size_t row = begin; row < end; ++row) {
    const ResidueRow& residue = page.rows.residues[row];
    const ImVec2 at{left + static_cast<float>(row - begin) * cell.x, corner.y};
    const ImVec2 to{at.x + cell.x, at.y + cell.y};
    const auto colour = secondary_colour(residue.secondary);
    if (is_selected(page, row)) {
      draw->AddRectFilled(at, to, to_u32(ctx.palette.selected, 0.55F));
    } else if (colour) {
      draw->AddRectFilled({at.x, at.y + cell.y * 0.86F}, {to.x, to.y}, to_u32(to_colour(*colour)));
    }
    if (page.pointed == row) draw->AddRect(at, to, to_u32(ctx.palette.accent), 2);
    const char letter[2] = {residue.letter, 0};
    const float inset = (cell.x - ImGui::CalcTextSize(letter).x) / 2;
    draw->AddText({at.x + inset, at.y}, to_u32(ctx.palette.text), letter);
  }
  ImGui::PopFont();
}

}  // namespace

void draw_sequences(StructurePage& page) {
  ImGui::PushFont(page.ctx.fonts.mono);
  const ImVec2 cell{ImGui::CalcTextSize("W").x + page.ctx.px(2),
                    ImGui::GetTextLineHeight() + page.ctx.px(2)};
  ImGui::PopFont();
  const float room = ImGui::GetContentRegionAvail().x - page.ctx.px(118);
  constexpr std::size_t kTens = 10;
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, room / cell.x));
  const std::size_t each = fitting >= kTens ? fitting / kTens * kTens : fitting;
  std::vector<std::pair<std::size_t, std::size_t>> first_lines;  // branch and its first line
  std::size_t lines = 0;
  for (std::size_t b = 0; b < page.rows.branches.size(); ++b) {
    if (page.rows.branches[b].kind != ResidueKind::polymer) continue;
    first_lines.emplace_back(b, lines);
    lines += (page.rows.branches[b].size() + each - 1) / each;
  }
  if (lines == 0) return muted_wrapped(page.ctx, "There is no protein or nucleic acid.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines), cell.y + page.ctx.px(4));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto line = static_cast<std::size_t>(i);
      const auto after =
          std::upper_bound(first_lines.begin(), first_lines.end(), line,
                           [](std::size_t l, const auto& f) { return l < f.second; });
      const auto& [b, first] = *(after - 1);
      const ResidueBranch& branch = page.rows.branches[b];
      const std::size_t begin = branch.begin + (line - first) * each;
      const float top = ImGui::GetCursorPosY();
      sequence_line(page, branch, begin, std::min(begin + each, branch.end), cell);
      ImGui::SetCursorPosY(top + cell.y + page.ctx.px(4));
    }
  }
}

}  // namespace alphascope
