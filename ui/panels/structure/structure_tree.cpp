// SPDX-License-Identifier: GPL-3.0-or-later
// The tree at the left of the page Structure. Only lines in sight are drawn.
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

// The lines of the tree in one frame. An assembly may have thousands of branches, so finding a line
// does not pass through them; residues of open branches are not listed one by one.
class TreeLines {
 public:
  explicit TreeLines(const StructurePage& page)
      : branches_(page.rows.branches),
        cavities_(lines_of_cavities(page)),
        channels_(lines_of_channels(page)) {
    std::size_t n = cavities_ + channels_;
    for (const ResidueBranch& branch : branches_) {
      starts_.push_back(n);
      n += 1 + (page.memory.open.contains(branch.title) ? branch.size() : 0);
    }
    starts_.push_back(n);
  }

  std::size_t size() const { return starts_.back(); }

  TreeLine at(std::size_t n) const {
    if (n == 0) return {TreeLine::Kind::cavities, 0, 0};
    if (n < cavities_) return {TreeLine::Kind::cavity, 0, n - 1};
    n -= cavities_;
    if (n == 0) return {TreeLine::Kind::channels, 0, 0};
    if (n < channels_) return {TreeLine::Kind::channel, 0, n - 1};
    n += cavities_;
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), n);
    const auto b = static_cast<std::size_t>(after - starts_.begin()) - 1;
    if (n == starts_[b]) return {TreeLine::Kind::branch, b, 0};
    return {TreeLine::Kind::residue, b, branches_[b].begin + n - starts_[b] - 1};
  }

  // The line of a row; empty if its branch is closed.
  std::optional<std::size_t> of(std::size_t row) const {
    const auto after =
        std::upper_bound(branches_.begin(), branches_.end(), row,
                         [](std::size_t r, const ResidueBranch& x) { return r < x.begin; });
    const auto b = static_cast<std::size_t>(after - branches_.begin()) - 1;
    const std::size_t line = starts_[b] + 1 + row - branches_[b].begin;
    return line < starts_[b + 1] ? std::optional(line) : std::nullopt;
  }

 private:
  const std::vector<ResidueBranch>& branches_;
  const std::size_t cavities_, channels_;
  std::vector<std::size_t> starts_;  // of each branch, then the number of lines
};

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
  const TreeLines lines(page);
  const float height = ImGui::GetTextLineHeightWithSpacing();
  // A residue under the mouse in the picture comes into sight.
  if (page.pointed && page.pointed != page.memory.hovered && page.pointed != page.memory.scrolled) {
    if (const auto line = lines.of(*page.pointed)) {
      const float at = static_cast<float>(*line) * height;
      const float top = ImGui::GetScrollY(), seen = ImGui::GetWindowHeight();
      if (at < top || at + height > top + seen) {
        ImGui::SetScrollY(std::max(0.0F, at - seen / 2));
      }
    }
  }
  page.memory.scrolled = page.pointed;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(std::min<std::size_t>(lines.size(), 1u << 30)), height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const TreeLine line = lines.at(static_cast<std::size_t>(i));
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
