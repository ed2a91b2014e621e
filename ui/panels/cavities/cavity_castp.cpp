// SPDX-License-Identifier: GPL-3.0-or-later
// The line that says whether the table is comparable with CASTp's, and the button that makes it so.
#include <string>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/settings/cavity_settings.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

void castp_line(PanelContext& ctx, const BallReferences& atoms) {
  constexpr const char *kComparable = "comparable with CASTp", *kNot = "not comparable with CASTp",
                       *kUse = "Use CASTp's choices";
  std::vector<std::string> differences = differences_from_castp(
      ctx.state.settings.open.balls, atoms.prepared().report, ctx.state.settings.request);
  if (ctx.state.settings.cavity_settings.split_networks) differences.push_back(kNetworksAreSplit);
  const float gap = ctx.px(8);
  same_line_where_it_fits(differences.empty()
                              ? ImGui::CalcTextSize(kComparable).x
                              : button_width(kUse) + gap + ImGui::CalcTextSize(kNot).x,
                          ctx.px(18));
  if (differences.empty()) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(to_imgui(ctx.palette.success), kComparable);
    record(ctx, "cavities.comparable");
    return;
  }
  if (button(ctx, "cavities.preset", kUse)) ctx.commands.run("cavities.castp");
  tooltip(ctx,
          "Sets CASTp's radii, solvent radius 1.4 Å and α = 0. Removes hydrogens, waters, ions "
          "and ligands from the body, and does not split networks. Undo restores the old "
          "settings.");
  std::string why = "Differences from CASTp: ";
  for (std::size_t k = 0; k < differences.size(); ++k) why += (k ? "; " : "") + differences[k];
  ImGui::SameLine(0, gap);
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(to_imgui(ctx.palette.warning), kNot);
  record(ctx, "cavities.comparable");
  tooltip(ctx, (why + ".").c_str());
}

}  // namespace alphascope
