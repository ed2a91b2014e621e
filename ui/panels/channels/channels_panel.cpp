// SPDX-License-Identifier: GPL-3.0-or-later
// The page of channels: both ends, the radius of the largest sphere that passes, the bottleneck,
// and the profile.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/chart/svg.hpp"
#include "core/document/channels/channel_export.hpp"
#include "core/document/channels/channel_records.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/molecule/molecule.hpp"
#include "core/text/as_sentence.hpp"
#include "ui/calls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/format.hpp"
#include "core/document/store/inputs.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/document/channels/channel_text.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/panels/view_state.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/document/settings/open_options.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {
namespace {

// Returns the id of found_channel() or found_ways(), whichever is shown.
const char* id_of(const ChannelState& memory) {
  return memory.from == ChannelFrom::ways ? "channel.ways" : "channel";
}

// Channels of larger molecules take minutes, so the user starts them by a button.
constexpr std::size_t kMostBallsUnasked = 200'000;

void take_balls(PanelContext& ctx, ChannelState& memory) {
  const PreparedBalls& prepared = ctx.state.references->prepared();
  if (memory.prepared.get() == &prepared) return;
  memory.prepared = {ctx.state.references, &prepared};
  memory.atoms = ctx.state.references;
  ++memory.balls_key;
  memory.main_axis = main_axis(*prepared.balls);
}

// If the user has just chosen a cavity, sets the channel to lead out of it.
void take_choice(const PanelContext& ctx, ChannelState& memory) {
  const RefSet& chosen = ctx.state.settings.selection.cavities;
  if (chosen == memory.cavities) return;
  memory.cavities = chosen;
  if (chosen.empty()) return;
  memory.from = ChannelFrom::cavity;
  if (memory.to != ChannelTo::mouth) memory.to = ChannelTo::out;
}

Inputs inputs_as_they_are(const ChannelState& memory) {
  Inputs inputs;
  inputs.balls = memory.prepared->balls;
  inputs.balls_key = memory.balls_key;
  inputs.atoms = memory.atoms;
  return inputs;
}

void take_answer(const PanelContext& ctx, ChannelState& memory,
                 const std::shared_ptr<const FoundChannel>& found) {
  if (memory.shown == found) return;
  memory.shown = found;
  memory.layers.clear();
  memory.cursor = -1;
  memory.touching.clear();
  memory.covering.clear();
  const BallReferences& atoms = *ctx.state.references;
  if (found->channel) memory.touching = touching_text(atoms, *found->channel);
  if (found->covering) memory.covering = atom_text(atoms, *found->covering);
}

// Turns the view across the line from one sample to another.
void look_across(PanelContext& ctx, const Channel& channel, std::size_t from, std::size_t to) {
  const RealPoint line =
      channel.samples[to].position_angstrom - channel.samples[from].position_angstrom;
  if (line != RealPoint{}) ctx.calls.view.look_across(unit_vector(line));
}

// Looks at the bottleneck across the channel. Seen from an end, outer atoms would hide it.
void look_across_bottleneck(PanelContext& ctx, const Channel& channel) {
  constexpr std::size_t kNear = 20;  // samples
  const std::size_t at = channel.bottleneck, last = channel.samples.size() - 1;
  look_across(ctx, channel, at - std::min(at, kNear), std::min(at + kNear, last));
}

// Looks across the whole line, and zooms out if it does not fit around the view's middle.
void look_across_line(PanelContext& ctx, const Channel& channel) {
  const ChannelSample &begin = channel.samples.front(), &end = channel.samples.back();
  look_across(ctx, channel, 0, channel.samples.size() - 1);
  constexpr double kMargin = 1.15;
  const double tall = length(end.position_angstrom - begin.position_angstrom) +
                      begin.radius_angstrom + end.radius_angstrom;
  const ViewportInfo& view = ctx.state.viewport;
  const double room = std::min(view.width, view.height) * view.angstrom_per_pixel;
  if (room > 0 && room < kMargin * tall) ctx.calls.view.zoom(room / (kMargin * tall));
}

void select_bottleneck(PanelContext& ctx, const ChannelState& memory) {
  std::vector<Ref> refs;
  for (const BallIndex ball : memory.shown->channel->touching) {
    refs.push_back(ctx.state.references->atom(ball));
  }
  ctx.state.settings.selection.items = RefSet(std::move(refs));
  ctx.calls.view.zoom_to_selection();
  look_across_bottleneck(ctx, *memory.shown->channel);
}

// --- results

// Draws the radius of the bottleneck beside the names of the pages.
void headline(PanelContext& ctx, const FoundChannel& found) {
  const Channel& channel = *found.channel;
  const double radius = channel.narrowest().radius_angstrom;
  ImGui::AlignTextToFramePadding();
  if (!channel.is_open()) {
    strong_text(ctx,
                "no way through: closed by " + number_text(-channel.widest_angstrom, 3) + " Å");
    record(ctx, "channels.result");
    tooltip(ctx, "Not even a point passes. All balls must shrink by this much before one does.");
    return;
  }
  strong_text(ctx, "bottleneck " + number_text(radius, 3) + " Å");
  record(ctx, "channels.result");
  tooltip(ctx,
          "Radius of the largest sphere that passes, exact to 0.001 Å. Neither alpha nor the "
          "solvent radius changes it.");
  ImGui::SameLine(0, ctx.px(12));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, passing_waters_text(found));
  record(ctx, "channels.passing");
}

void progress(PanelContext& ctx, ChannelState& memory, const Derived<FoundChannel>& found) {
  const std::string text = percent_text(found.share);
  const bool runs = found.state == DerivedState::running;
  ImGui::ProgressBar(static_cast<float>(found.share), {ctx.px(150), ImGui::GetFrameHeight()},
                     runs ? text.c_str() : "waiting");
  record(ctx, "channels.progress");
  tooltip(ctx, "Searching for the widest way. You can go on working.");
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "channels.cancel", "Cancel")) ctx.store.cancel(id_of(memory));
}

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

std::vector<FormatToSave> exports_of(const std::shared_ptr<const FoundChannel>& found,
                                     const RecordSource& source, const std::string& title) {
  std::vector<FormatToSave> formats;
  for (const ShapeExportInfo& info : channel_exports()) {
    formats.push_back(format_to_save(info, channel_export(info, found, source)));
  }
  formats.push_back(figure_to_save(plot_svg(profile_plot(*found->channel), title)));
  return formats;
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
  const RecordSource source = source_on_screen(ctx);
  if (button(ctx, "channels.copy", "Copy profile")) {
    ImGui::SetClipboardText(channel_csv_text(channel, source).c_str());
    ctx.state.notice = "Profile copied as CSV: " +
                       with_separators(static_cast<long long>(channel.samples.size())) + " rows.";
  }
  tooltip(ctx, "Copies length, radius and position every 0.1 Å as CSV for a spreadsheet.");
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "channels.save", "Save…")) {
    open_save_dialog(ctx, {"Channel",
                           file_name_for(ctx, "channel"),
                           channel_csv(memory.shown, source),
                           channel_as_json(memory.shown, source),
                           {},
                           false,
                           exports_of(memory.shown, source, ctx.state.file_name())});
  }
  tooltip(ctx,
          "The profile as a CSV or SVG file, the channel as a JSON file, or its surface, spheres "
          "along it or a script for other programs.");
  ImGui::EndDisabled();
}

void problem(PanelContext& ctx, const std::string& text) {
  wrapped_text(text);
  record(ctx, "channels.problem");
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

void column_of_results(PanelContext& ctx, ChannelState& memory, const Derived<FoundChannel>& found,
                       bool current) {
  if (found.state == DerivedState::failed || found.state == DerivedState::no_room) {
    return problem(ctx, "There is no channel. " + found.why);
  }
  if (found.state == DerivedState::cancelled) {
    muted_text(ctx, "Cancelled.");
    ImGui::SameLine(0, ctx.px(8));
    if (button(ctx, "channels.again", "Compute")) {
      ctx.store.retry(id_of(memory));
    }
    return;
  }
  if (!memory.shown) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  if (memory.shown->channel) {
    details(ctx, memory, current);
  } else {
    problem(ctx, no_channel_text(memory));
    if (memory.shown->covering) guest_line(ctx, {*memory.shown->covering}, current);
  }
  ImGui::PopStyleVar();
}

// Returns whether the question may be computed. A large one waits until the user starts it.
bool may_begin(PanelContext& ctx, ChannelState& memory, const AnyDefinition& wanted) {
  const std::size_t balls = memory.prepared->balls->size();
  if (balls <= kMostBallsUnasked) return true;
  const Key key = wanted.key(inputs_as_they_are(memory));
  if (memory.asked_for == key.number()) return true;
  if (button(ctx, "channels.compute", "Compute the channel", {0, 0}, ButtonKind::primary)) {
    memory.asked_for = key.number();
  }
  tooltip(ctx, "The search takes a while for so many balls. You can go on working.");
  return memory.asked_for == key.number();
}

// Returns the chosen way in the form of a result of found_channel(). It has no value if there are
// no ways.
Derived<FoundChannel> want_way(PanelContext& ctx, ChannelState& memory, Derived<FoundWays>& ways) {
  ways = ctx.store.want(found_ways(), inputs_as_they_are(memory));
  Derived<FoundChannel> found;
  found.state = ways.state;
  found.share = ways.share;
  found.why = ways.why;
  if (!ways.ready() || ways.value->ways.empty()) return found;
  memory.way = std::clamp<std::size_t>(memory.way, 1, ways.value->ways.size());
  found.value = ways.value->ways[memory.way - 1];
  memory.last_from = found.value->ends.from;
  return found;
}

void first_line(PanelContext& ctx, ChannelState& memory, const Derived<FoundChannel>& found,
                bool current) {
  if (found.state == DerivedState::waiting || found.state == DerivedState::running) {
    progress(ctx, memory, found);
  } else if (current && memory.shown && memory.shown->channel) {
    headline(ctx, *memory.shown);
  } else {
    ImGui::NewLine();
  }
}

constexpr const char* kNoWay =
    "No way leads through the molecule from outside to outside. Choose above where a channel "
    "begins.";

void page(PanelContext& ctx, ChannelState& memory) {
  const bool of_ways = memory.from == ChannelFrom::ways;
  ChannelRequest question;
  if (!of_ways) question = channel_request(ctx, memory);
  Derived<FoundWays> ways;
  Derived<FoundChannel> found;
  const bool has_question = of_ways || question.ends;
  bool asked = true;
  if (of_ways && (asked = may_begin(ctx, memory, found_ways()))) {
    found = want_way(ctx, memory, ways);
  } else if (question.ends && (asked = may_begin(ctx, memory, found_channel(*question.ends)))) {
    found = ctx.store.want(found_channel(*question.ends), inputs_as_they_are(memory));
  }
  const bool no_way = of_ways && ways.ready() && ways.value->ways.empty();
  if (no_way) memory.shown = nullptr;
  if (found.ready() && found.value) take_answer(ctx, memory, found.value);
  const bool current = found.ready() && found.value && memory.shown == found.value;
  if (has_question && asked) {
    first_line(ctx, memory, found, current);
  } else if (!has_question) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, question.waiting ? question.why : "");
  }
  constexpr float kColumn = 410;
  ImGui::BeginChild("ends", {ctx.px(kColumn), 0}, false);
  draw_channel_ends(ctx, memory);
  if (of_ways && ways.ready()) draw_ways(ctx, memory, *ways.value);
  ImGui::Dummy({0, ctx.px(2)});
  if (no_way) {
    problem(ctx, kNoWay);
  } else if (!has_question && !question.waiting) {
    problem(ctx, question.why);
    if (question.wants_cavity && button(ctx, "channels.cavities", "Go to Cavities")) {
      ctx.state.window.page = "cavities";
    }
  } else {
    column_of_results(ctx, memory, found, current);
  }
  ImGui::EndChild();
  if (!memory.shown || !memory.shown->channel) return;
  ImGui::SameLine(0, ctx.px(10));
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.4f);
  ImGui::BeginChild("profile", {0, 0}, false, ImGuiWindowFlags_NoScrollbar);
  draw_channel_profile(ctx, memory, *memory.shown->channel);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (current) show_channel(ctx, memory);
}

void draw_channels(PanelContext& ctx, ChannelState& memory) {
  reset_for_molecule(memory, ctx.state.file_hash(), [](const ChannelState& old) {
    ChannelState fresh;
    fresh.balls_key = old.balls_key;  // no two sets of balls may share a key
    return fresh;
  });
  if (!ctx.state.has_molecule() || !ctx.state.references ||
      ctx.state.references->prepared().balls->size() == 0) {
    muted_wrapped(ctx, "Open a molecule: the channels through it appear here.");
    record(ctx, "channels.waiting");
    return;
  }
  take_balls(ctx, memory);
  take_choice(ctx, memory);
  page(ctx, memory);
}

}  // namespace

std::unique_ptr<Panel> channels_panel() {
  return panel_of(draw_channels);
}

}  // namespace alphascope
