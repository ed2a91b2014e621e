// SPDX-License-Identifier: GPL-3.0-or-later
// The branch of cavities in the tree.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "core/document/cavities/cavity_results.hpp"
#include "core/document/tables/cell_value.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kCavities = "Cavities";

// Null while the table of cavities is not known, or its branch is closed.
const CavityLines* open_cavities(const StructurePage& page) {
  const CavityPage* const cavities = page.ctx.state.cavities.page.get();
  const bool open = page.memory.open.contains(kCavities);
  return open && cavities != nullptr ? cavities->rows.lines.get() : nullptr;
}

}  // namespace

void follow_tree_of_cavities(PanelContext& ctx, const StructureState& memory) {
  const bool chosen = !ctx.state.settings.selection.cavities.empty();
  if (!chosen && !memory.open.contains(kCavities)) return;
  const bool current = follow_cavities(ctx).current;
  CavityPage& cavities = *ctx.state.cavities.page;
  if (cavities.rows.lines) draw_layers_of_cavities(ctx, cavities, current);
}

std::size_t lines_of_cavities(const StructurePage& page) {
  const CavityLines* const cavities = open_cavities(page);
  return 1 + (cavities != nullptr ? cavities->of.size() : 0);
}

void draw_title_of_cavities(StructurePage& page) {
  auto& open = page.memory.open;
  const bool is_open = open.contains(kCavities);
  ImGui::SetNextItemOpen(is_open);
  const CavityLines* const lines = open_cavities(page);
  const std::string text = is_open && lines == nullptr ? "Cavities are being found"
                           : lines == nullptr
                               ? kCavities
                               : std::string(kCavities) + "  " + count_text(lines->of.size());
  const bool now = ImGui::TreeNodeEx(
      "##cavities", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
      text.c_str());
  record(page.ctx, "structure.cavities");
  tooltip(page.ctx, "Voids and pockets of the complex on screen, as on the page Cavities.");
  if (now != is_open) now ? (void)open.insert(kCavities) : (void)open.erase(kCavities);
}

void draw_cavity(StructurePage& page, std::size_t row) {
  CavityPage& cavities = *page.ctx.state.cavities.page;
  const CavityLine& line = cavities.rows.lines->of[row];
  const bool marked =
      page.ctx.state.cavities.under_mouse == row ||
      std::binary_search(cavities.selected_rows.begin(), cavities.selected_rows.end(), row);
  const std::string text = std::to_string(row + 1) + "  " + kind_word(line) + "  " +
                           measure_text(line.volume_sa_angstrom3) + " Å³";
  ImGui::Indent(page.ctx.px(22));
  if (ImGui::Selectable((text + "##cavity" + std::to_string(row)).c_str(), marked)) {
    const ImGuiIO& io = ImGui::GetIO();
    select_cavity(page.ctx, cavities, row,
                  io.KeyShift  ? HowSelected::range
                  : io.KeyCtrl ? HowSelected::toggled
                               : HowSelected::alone);
  }
  record(page.ctx, ("structure.cavity." + std::to_string(row + 1)).c_str());
  if (ImGui::IsItemHovered()) cavities.hovered = row;
  ImGui::Unindent(page.ctx.px(22));
}

}  // namespace alphascope
