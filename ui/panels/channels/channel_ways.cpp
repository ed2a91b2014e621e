// SPDX-License-Identifier: GPL-3.0-or-later
// The table of ways through a molecule.
#include <span>
#include <string>
#include <utility>

#include "core/document/channels/channel_columns.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/tables/column.hpp"
#include "core/selection/selection_error.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// A column's place in the table, with its share of the width.
constexpr std::pair<const char*, float> kPlaces[] = {
    {"through", 5.0F}, {"widest_angstrom", 2.4F}, {"position", 4.4F}, {"length_angstrom", 2.0F}};

const Column<FoundChannel>& column(const char* id) {
  return column_of(way_columns(), id);
}

std::string way_help(const FoundChannel& found) {
  const WayFacts& way = *found.way;
  return "Through " + way.through + ", lined by " + chains_text(way.lining_chains) +
         ".\nNarrowest at " + bottleneck_place(*found.channel) + " Å.\nCovers " +
         cover_text(*found.cover) + ".\nClick to show it.";
}

}  // namespace

void draw_ways(PanelContext& ctx, ChannelState& memory, const FoundWays& ways) {
  if (ways.ways.empty()) return;
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("ways", 4, kFlags)) return;
  for (const auto& [id, share] : kPlaces) {
    ImGui::TableSetupColumn(column(id).heading().c_str(), ImGuiTableColumnFlags_WidthStretch,
                            share);
  }
  ImGui::TableHeadersRow();
  for (const auto& found : ways.ways) {
    const std::size_t number = found->way->number;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = found->way->through + "##way" + std::to_string(number);
    if (ImGui::Selectable(label.c_str(), memory.way == number,
                          ImGuiSelectableFlags_SpanAllColumns)) {
      memory.way = number;
    }
    record(ctx, ("channels.way." + std::to_string(number)).c_str());
    tooltip(ctx, way_help(*found).c_str());
    for (const auto& [id, share] : std::span(kPlaces).subspan(1)) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(column(id).shown_text(*found).c_str());
    }
  }
  ImGui::EndTable();
  if (ways.parts_left_out == 0) return;
  muted_wrapped(ctx, "There are too many chains: " + grouped(ways.parts_left_out) +
                         " were not searched separately.");
  record(ctx, "channels.left_out");
}

}  // namespace alphascope
