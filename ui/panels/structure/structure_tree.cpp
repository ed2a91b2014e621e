// SPDX-License-Identifier: GPL-3.0-or-later
// The tree at the left of the page Structure. Only lines in sight are drawn.
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "core/document/reference/reference.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// A line of the tree: a branch or a residue of it; the branches of cavities and channels, or one of
// them.
struct TreeLine {
  enum class Kind : std::uint8_t {
    branch,
    residue,
    cavities,
    cavity,
    channels,
    channel
  } kind = Kind::branch;
  std::size_t branch = 0, row = 0;
};

// The nth visible line. Branches are few; the residues of open ones are not listed one by one.
TreeLine line_at(const StructurePage& page, std::size_t n) {
  if (n == 0) return {TreeLine::Kind::cavities, 0, 0};
  if (n < lines_of_cavities(page)) return {TreeLine::Kind::cavity, 0, n - 1};
  n -= lines_of_cavities(page);
  if (n == 0) return {TreeLine::Kind::channels, 0, 0};
  if (n < lines_of_channels(page)) return {TreeLine::Kind::channel, 0, n - 1};
  n -= lines_of_channels(page);
  for (std::size_t b = 0; b < page.rows.branches.size(); ++b) {
    if (n == 0) return {TreeLine::Kind::branch, b, 0};
    --n;
    const ResidueBranch& branch = page.rows.branches[b];
    if (!page.memory.open.contains(branch.title)) continue;
    if (n < branch.size()) return {TreeLine::Kind::residue, b, branch.begin + n};
    n -= branch.size();
  }
  return {TreeLine::Kind::cavities, 0, 0};
}

// The index of a row's line; empty if its branch is closed.
std::optional<std::size_t> line_of(const StructurePage& page, std::size_t row) {
  std::size_t n = lines_of_cavities(page) + lines_of_channels(page);
  for (const ResidueBranch& branch : page.rows.branches) {
    ++n;
    const bool open = page.memory.open.contains(branch.title);
    if (row >= branch.begin && row < branch.end) {
      return open ? std::optional(n + row - branch.begin) : std::nullopt;
    }
    if (open) n += branch.size();
  }
  return std::nullopt;
}

void branch_line(StructurePage& page, std::size_t b) {
  const ResidueBranch& branch = page.rows.branches[b];
  auto& open = page.memory.open;
  const bool is_open = open.contains(branch.title);
  ImGui::SetNextItemOpen(is_open);
  const std::string text = branch.title + "  " + count_text(branch.size());
  const bool now =
      ImGui::TreeNodeEx(("##branch" + std::to_string(b)).c_str(),
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                            ImGuiTreeNodeFlags_OpenOnArrow,
                        "%s", text.c_str());
  const bool toggled = ImGui::IsItemToggledOpen();
  record(page.ctx, ("structure.branch." + std::to_string(b + 1)).c_str());
  take_mouse(page, branch.begin, branch.end, ImGui::IsItemClicked() && !toggled);
  tooltip(page.ctx, "A click selects it, a click on the arrow opens it.");
  if (now == is_open) return;
  now ? (void)open.insert(branch.title) : (void)open.erase(branch.title);
}

void residue_line(StructurePage& page, std::size_t row) {
  const std::string title = residue_title(page.atoms.molecule(), page.rows.residues[row]);
  ImGui::Indent(page.ctx.px(22));
  const bool marked = is_selected(page, row) || page.pointed == row;
  const bool clicked = ImGui::Selectable((title + "##" + std::to_string(row)).c_str(), marked);
  record(page.ctx, ("structure.residue." + std::to_string(row + 1)).c_str());
  take_mouse(page, row, row + 1, clicked);
  ImGui::Unindent(page.ctx.px(22));
}

}  // namespace

void draw_tree(StructurePage& page) {
  std::size_t lines = page.rows.branches.size();
  for (const ResidueBranch& branch : page.rows.branches) {
    if (page.memory.open.contains(branch.title)) lines += branch.size();
  }
  lines += lines_of_cavities(page) + lines_of_channels(page);
  const float height = ImGui::GetTextLineHeightWithSpacing();
  // A residue under the mouse in the picture comes into sight.
  if (page.pointed && page.pointed != page.memory.hovered && page.pointed != page.memory.scrolled) {
    if (const auto line = line_of(page, *page.pointed)) {
      const float at = static_cast<float>(*line) * height;
      const float top = ImGui::GetScrollY(), seen = ImGui::GetWindowHeight();
      if (at < top || at + height > top + seen) {
        ImGui::SetScrollY(std::max(0.0F, at - seen / 2));
      }
    }
  }
  page.memory.scrolled = page.pointed;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(std::min<std::size_t>(lines, 1u << 30)), height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const TreeLine line = line_at(page, static_cast<std::size_t>(i));
      switch (line.kind) {
        case TreeLine::Kind::branch:
          branch_line(page, line.branch);
          break;
        case TreeLine::Kind::residue:
          residue_line(page, line.row);
          break;
        case TreeLine::Kind::cavities:
          draw_title_of_cavities(page);
          break;
        case TreeLine::Kind::cavity:
          draw_cavity(page, line.row);
          break;
        case TreeLine::Kind::channels:
          draw_title_of_channels(page);
          break;
        case TreeLine::Kind::channel:
          draw_channel(page, line.row);
          break;
      }
    }
  }
}

}  // namespace alphascope
