// The table of ways through a molecule.
#include <string>

#include "core/text/grouped_number.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

std::string bottleneck_place(const Channel& channel) {
  const RealPoint& p = channel.narrowest().position_angstrom;
  return number_text(p.x, 1) + ", " + number_text(p.y, 1) + ", " + number_text(p.z, 1) + " Å";
}

std::string way_help(const FoundChannel& found) {
  const WayNote& way = *found.way;
  return "Through " + way.through + ", lined by " + chains_text(way.lining_chains) +
         ".\nNarrowest at " + bottleneck_place(*found.channel) + ".\nCovers " +
         cover_text(*found.cover) + ".\nClick to take it.";
}

}  // namespace

void draw_ways(PanelContext& ctx, ChannelMemory& memory, const FoundWays& ways) {
  if (ways.ways.empty()) return;
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("ways", 4, kFlags)) return;
  for (const auto& [title, share] :
       {std::pair{"through", 5.0F}, {"bottleneck", 2.4F}, {"at", 4.4F}, {"length", 2.0F}}) {
    ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, share);
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
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(
        (number_text(found->channel->narrowest().radius_angstrom, 3) + " Å").c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(bottleneck_place(*found->channel).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted((number_text(found->channel->length_angstrom, 1) + " Å").c_str());
  }
  ImGui::EndTable();
  if (ways.parts_left_out == 0) return;
  muted_wrapped(ctx, "Of too many chains, " + grouped(ways.parts_left_out) +
                         " were not looked through by themselves.");
  record(ctx, "channels.left_out");
}

}  // namespace alphascope
