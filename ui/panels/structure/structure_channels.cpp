// SPDX-License-Identifier: GPL-3.0-or-later
// The branch of channels in the tree: the ways through the molecule, as on the page Channels.
#include <imgui.h>

#include <string>

#include "core/document/channels/channel_results.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/store/definition.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/structure/structure_page.hpp"
#include "ui/panels/structure/structure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kChannels = "Channels";

const FoundWays* open_ways(const StructurePage& page) {
  return page.memory.open.contains(kChannels) ? page.memory.ways.get() : nullptr;
}

}  // namespace

void follow_tree_of_channels(PanelContext& ctx, StructureState& memory) {
  if (!memory.open.contains(kChannels)) return;
  ChannelState& channels = ctx.state.channels;
  memory.ways = nullptr;
  memory.ways_problem.clear();
  if (!follow_molecule_of_channels(ctx, channels)) return;
  const Derived<FoundWays> ways = want_ways(ctx, channels);
  if (!ways.ready()) {
    const bool over = ways.state == DerivedState::failed || ways.state == DerivedState::no_room ||
                      ways.state == DerivedState::cancelled;
    if (over) memory.ways_problem = ways.why.empty() ? "The search was cancelled." : ways.why;
    return;
  }
  memory.ways = ways.value;
  const std::size_t number = memory.hovered_way != 0 ? memory.hovered_way : memory.way;
  if (number == 0 || number > ways.value->ways.size()) return;
  take_found_channel(ctx, channels, ways.value->ways[number - 1]);
  show_channel(ctx, channels);
}

std::size_t lines_of_channels(const StructurePage& page) {
  const FoundWays* const ways = open_ways(page);
  return 1 + (ways != nullptr ? ways->ways.size() : 0);
}

void draw_title_of_channels(StructurePage& page) {
  auto& open = page.memory.open;
  const bool is_open = open.contains(kChannels);
  ImGui::SetNextItemOpen(is_open);
  const FoundWays* const ways = open_ways(page);
  const std::string& problem = page.memory.ways_problem;
  std::string text = kChannels;
  if (ways != nullptr) {
    text += "  " + count_text(ways->ways.size());
  } else if (is_open) {
    text = problem.empty() ? "Channels are being found" : "Channels are not found";
  }
  const bool now = ImGui::TreeNodeEx(
      "##channels", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
      text.c_str());
  record(page.ctx, "structure.channels");
  tooltip(page.ctx, is_open && !problem.empty()
                        ? problem.c_str()
                        : "Ways through the molecule, as on the page Channels.");
  if (now != is_open) now ? (void)open.insert(kChannels) : (void)open.erase(kChannels);
}

// A click on the chosen channel hides it.
void draw_channel(StructurePage& page, std::size_t row) {
  const FoundChannel& found = *page.memory.ways->ways[row];
  const std::size_t number = row + 1;
  const std::string text = std::to_string(number) + "  " + found.way->through + "  " +
                           bottleneck_radius_text(*found.channel) + " Å";
  ImGui::Indent(page.ctx.px(22));
  if (ImGui::Selectable((text + "##channel" + std::to_string(row)).c_str(),
                        page.memory.way == number)) {
    page.memory.way = page.memory.way == number ? 0 : number;
    page.ctx.state.channels.from = ChannelFrom::ways;
    page.ctx.state.channels.way = number;
  }
  record(page.ctx, ("structure.channel." + std::to_string(number)).c_str());
  if (ImGui::IsItemHovered()) page.hovered_way = number;
  tooltip(page.ctx, "Radius of the largest sphere that passes. A click keeps the channel shown.");
  ImGui::Unindent(page.ctx.px(22));
}

}  // namespace alphascope
