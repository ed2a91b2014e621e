// SPDX-License-Identifier: GPL-3.0-or-later
// The channel that was found, in words: its bottleneck, its length, the atoms that it touches, and
// what is in its way. Or the reason why there is none.
#include <algorithm>
#include <string>
#include <vector>

#include "core/document/channels/channel_results.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/residue_kind.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

void limit_line(PanelContext& ctx, const Channel& channel) {
  if (channel.limit == ChannelLimit::passage) return;
  muted_wrapped(ctx, std::string("Narrowest ") + channel_limit_text(channel.limit) + ".");
}

// An ion, ligand or water that closes the pore in the crystal, although it may not stay there.
struct Guest {
  ResidueKind kind;
  const char *one, *some;
  bool BallOptions::*kept;
};
constexpr Guest kGuests[] = {{ResidueKind::ion, "An ion", "ions", &BallOptions::ions},
                             {ResidueKind::ligand, "A ligand", "ligands", &BallOptions::ligands},
                             {ResidueKind::water, "A water", "waters", &BallOptions::waters}};

void guest_line(PanelContext& ctx, const std::vector<BallIndex>& touching, bool current) {
  const BallReferences& atoms = *ctx.state.references;
  if (!current) return;
  for (const Guest& guest : kGuests) {
    const bool touches = std::any_of(touching.begin(), touching.end(), [&](BallIndex ball) {
      return atoms.molecule().atoms[atoms.prepared().atom_of_ball.at(ball)].kind == guest.kind;
    });
    if (!touches) continue;
    wrapped_text(std::string(guest.one) + " is in its way.");
    if (button(ctx, "channels.guests", (std::string("Leave ") + guest.some + " out").c_str())) {
      ctx.state.settings.open.balls.*guest.kept = false;
    }
    tooltip(ctx, "These are the switches of the section Molecule, Keep. Undo restores the atoms.");
    return;
  }
}

// Says which part of the molecule the channel covers, and what is in it.
void cover_lines(PanelContext& ctx, const FoundChannel& found) {
  std::string text = "covers " + cover_text(*found.cover);
  if (found.way) {
    text = "through " + found.way->through + ", lined by " + chains_text(found.way->lining_chains) +
           "; " + text;
  }
  muted_wrapped(ctx, text);
  record(ctx, "channels.cover");
  tooltip(ctx,
          "Length of the line along the molecule, from centre to centre. Each open end lies "
          "where the channel is wider than anywhere inside.");
  if (!found.way || pore_contents_text(*found.way).empty()) return;
  wrapped_text("In the channel, but ignored: " + pore_contents_text(*found.way) + ".");
  record(ctx, "channels.not_counted");
}

void details(PanelContext& ctx, const ChannelState& memory, bool current) {
  const Channel& channel = *memory.shown->channel;
  const RealPoint& p = channel.narrowest().position_angstrom;
  wrapped_text("length " + number_text(channel.length_angstrom, 1) + " Å, narrowest at " +
               number_text(p.x, 2) + ", " + number_text(p.y, 2) + ", " + number_text(p.z, 2) +
               " Å");
  record(ctx, "channels.place");
  muted_wrapped(ctx, "touched there by " + memory.touching);
  record(ctx, "channels.touching");
  cover_lines(ctx, *memory.shown);
  limit_line(ctx, channel);
  guest_line(ctx, channel.touching, current);
  ImGui::BeginDisabled(!current);
  if (button(ctx, "channels.show", "Show the bottleneck")) select_bottleneck(ctx, memory);
  tooltip(ctx, "Selects the atoms at the bottleneck and shows it from the side.");
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "channels.across", "From the side")) look_across_line(ctx, channel);
  tooltip(ctx, "Turns the view until it looks across the whole line, and shows all of it.");
  ImGui::SameLine(0, ctx.px(8));
  channel_save_buttons(ctx, memory.shown);
  ImGui::EndDisabled();
}

std::string no_channel_text(const ChannelState& memory) {
  const FoundChannel& found = *memory.shown;
  if (!found.covering) return as_sentence(found.why);
  std::string text = "The channel would end inside the atom " + memory.covering + ", " +
                     number_text(found.depth_angstrom, 2) + " Å below its surface. ";
  return text + (found.ends.kind == ChannelEnds::Kind::through
                     ? "Choose a start nearer to the pore, or another direction."
                     : "Choose a point outside all balls, or “both ways along”, which moves the "
                       "start into the pore.");
}

}  // namespace

void channel_headline(PanelContext& ctx, const FoundChannel& found) {
  const Channel& channel = *found.channel;
  ImGui::AlignTextToFramePadding();
  if (!channel.is_open()) {
    strong_text(ctx,
                "no way through: closed by " + number_text(-channel.widest_angstrom, 3) + " Å");
    record(ctx, "channels.result");
    tooltip(ctx, "Not even a point passes. All balls must shrink by this much before one does.");
    return;
  }
  strong_text(ctx, "bottleneck " + bottleneck_radius_text(channel) + " Å");
  record(ctx, "channels.result");
  tooltip(
      ctx,
      "Radius of the largest sphere that passes, rounded down to 0.001 Å. Neither alpha nor the "
      "solvent radius changes it.");
  ImGui::SameLine(0, ctx.px(12));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, passing_waters_text(found));
  record(ctx, "channels.passing");
}

void channel_problem(PanelContext& ctx, const std::string& text) {
  wrapped_text(text);
  record(ctx, "channels.problem");
}

void draw_found_channel(PanelContext& ctx, const ChannelState& memory, bool current) {
  if (memory.shown->channel) {
    details(ctx, memory, current);
  } else {
    channel_problem(ctx, no_channel_text(memory));
    if (memory.shown->covering) guest_line(ctx, {*memory.shown->covering}, current);
  }
}

}  // namespace alphascope
