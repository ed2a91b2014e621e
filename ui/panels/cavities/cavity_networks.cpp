// SPDX-License-Identifier: GPL-3.0-or-later
// The notes on networks: a giant one that has nearly all empty space, the solvent radius at which
// one falls apart, and the choice to list its parts.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/channels/network_results.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/settings/cavity_settings.hpp"
#include "core/document/settings/request.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Solvent radius, Å. Below it a note warns that one giant pocket contains nearly everything.
constexpr double kGiantBelow = 0.5;

// Returns the row of the chosen network, else of the largest one.
std::optional<std::size_t> network_row(const CavityPage& page) {
  const std::vector<CavityLine>& lines = page.rows.lines->of;
  if (page.selected_rows.size() == 1 && lines[page.selected_rows.front()].is_network) {
    return page.selected_rows.front();
  }
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [](const CavityLine& line) { return line.is_network; });
  if (first == lines.end()) return {};
  return static_cast<std::size_t>(first - lines.begin());
}

Derived<FoundNetworkEnd> want_end(PanelContext& ctx, const CavityPage& page, std::size_t row) {
  return ctx.store.want(network_end(page.rows.table().sink(row)), ctx.inputs);
}

// Says at which solvent radius the network falls apart, with a button that sets it.
void end_of_network(PanelContext& ctx, const CavityPage& page, std::size_t row) {
  const Derived<FoundNetworkEnd> found = want_end(ctx, page, row);
  const std::string number = grouped(row + 1);
  std::string text;
  if (found.ready()) {
    const NetworkEnd& end = found.value->end;
    text = "Cavity " + number + " is a network at a solvent radius of " +
           short_number_text(end.largest_radius_angstrom, 1) + " Å, too";
    if (end.radius_angstrom) {
      const std::string label = "Use " + short_number_text(*end.radius_angstrom, 1) + " Å";
      if (button(ctx, "cavities.network.radius", label.c_str())) {
        ctx.state.settings.request.solvent_radius_angstrom = *end.radius_angstrom;
      }
      tooltip(ctx, ("Sets the solvent radius. " +
                    falls_apart_text(end, ctx.inputs.solvent_radius_angstrom))
                       .c_str());
      ImGui::SameLine(0, ctx.px(8));
      text = "There cavity " + number + " falls apart: " +
             (end.cavities == 0 ? "nothing is left of it"
                                : counted(end.cavities, "cavity is", "cavities are") + " left");
    }
  } else if (found.state == DerivedState::failed || found.state == DerivedState::no_room) {
    text = "Where cavity " + number + " falls apart is not known: " + found.why;
  } else {
    text = "Cavity " + number + " is a network: looking for the radius at which it falls apart, " +
           percent_text(found.share);
  }
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, found.ready() ? "cavities.network" : "cavities.network.looking");
}

std::string split_text(const CavityTable& table) {
  std::size_t parts = 0;
  for (const SplitNetwork& network : table.found.networks) parts += network.parts;
  const std::size_t networks = table.found.networks.size();
  return counted(networks, "network is", "networks are") + " listed as " +
         counted(parts, "part", "parts");
}

}  // namespace

void giant_network_line(PanelContext& ctx, const CavityPage& page) {
  if (ctx.inputs.solvent_radius_angstrom >= kGiantBelow) return;
  const auto& lines = page.rows.lines->of;
  if (std::none_of(lines.begin(), lines.end(), [](const auto& line) { return line.is_network; })) {
    return;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(to_imgui(ctx.palette.warning),
                     "With a solvent radius below %.1f Å most of the "
                     "empty space is one giant pocket.",
                     kGiantBelow);
  record(ctx, "cavities.giant");
  same_line_where_it_fits(button_width("Use 1.4 Å"), ctx.px(10));
  if (button(ctx, "cavities.water", "Use 1.4 Å")) {
    ctx.state.settings.request.solvent_radius_angstrom = kCavitySolventAngstrom;
  }
  tooltip(ctx,
          "Sets the solvent radius to 1.4 Å, the radius of a water molecule. Every listed cavity "
          "then has room for one.");
}

void networks_line(PanelContext& ctx, const CavityPage& page, bool current) {
  bool& split = ctx.state.settings.cavity_settings.split_networks;
  const std::optional<std::size_t> row = network_row(page);
  const CavityTable& table = page.rows.table();
  if (!row && !split && table.found.networks.empty()) return;
  checkbox(ctx, "cavities.split_networks", "Split networks at their bottlenecks", split);
  tooltip(ctx,
          "Lists each network as its parts, at the present alpha and solvent radius. Parts are "
          "the cavities into which it splits as alpha grows. Passages between parts are not "
          "mouths. CASTp does not split networks.");
  if (!table.found.networks.empty()) {
    ImGui::SameLine(0, ctx.px(14));
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, split_text(table));
    record(ctx, "cavities.networks");
  }
  if (!row || !current) return;
  constexpr float kLeast = 240;  // pixels at scale 1, for a button and the beginning of a sentence
  same_line_where_it_fits(ctx.px(kLeast), ctx.px(14));
  end_of_network(ctx, page, *row);
}

std::string part_text(const CavityLine& line) {
  if (!line.is_part) return {};
  return "It is a part of a network, and is joined to other parts through " +
         counted(line.passages, "passage", "passages") + ".";
}

void network_end_sentences(PanelContext& ctx, const CavityPage& page, std::size_t row) {
  if (!page.rows.lines->of[row].is_network || !page.rows.lines->is_of(ctx.inputs)) return;
  const Derived<FoundNetworkEnd> found = want_end(ctx, page, row);
  if (!found.ready()) return;
  muted_wrapped(ctx, falls_apart_text(found.value->end, ctx.inputs.solvent_radius_angstrom));
  record(ctx, "cavities.falls_apart");
}

}  // namespace alphascope
