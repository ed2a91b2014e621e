// SPDX-License-Identifier: GPL-3.0-or-later
// The page of channels: both ends, the radius of the largest sphere that passes, the bottleneck,
// and the profile.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/channels/channel_text.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

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

void column_of_results(PanelContext& ctx, ChannelState& memory, const Derived<FoundChannel>& found,
                       bool current) {
  if (found.state == DerivedState::failed || found.state == DerivedState::no_room) {
    return channel_problem(ctx, "There is no channel. " + found.why);
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
  draw_found_channel(ctx, memory, current);
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
  ways = want_ways(ctx, memory);
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
    channel_headline(ctx, *memory.shown);
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
  if (found.ready() && found.value) take_found_channel(ctx, memory, found.value);
  const bool current = found.ready() && found.value && memory.shown == found.value;
  if (has_question && asked) {
    first_line(ctx, memory, found, current);
  } else if (!has_question) {
    ImGui::AlignTextToFramePadding();
    muted_text(ctx, question.waiting ? question.why : "");
  }
  constexpr float kColumn = 410;
  ImGui::BeginChild("ends", {std::min(ctx.px(kColumn), ImGui::GetContentRegionAvail().x), 0},
                    false);
  draw_channel_ends(ctx, memory);
  if (of_ways && ways.ready()) draw_ways(ctx, memory, *ways.value);
  ImGui::Dummy({0, ctx.px(2)});
  if (no_way) {
    channel_problem(ctx, kNoWay);
  } else if (!has_question && !question.waiting) {
    channel_problem(ctx, question.why);
    if (question.wants_cavity && button(ctx, "channels.cavities", "Go to Cavities")) {
      ctx.state.show_page("cavities");
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

void draw_channels(PanelContext& ctx) {
  ChannelState& memory = ctx.state.channels;
  if (!follow_molecule_of_channels(ctx, memory)) {
    muted_wrapped(ctx, "Open a molecule: the channels through it appear here.");
    record(ctx, "channels.waiting");
    return;
  }
  take_choice(ctx, memory);
  page(ctx, memory);
}

}  // namespace

bool follow_molecule_of_channels(PanelContext& ctx, ChannelState& memory) {
  reset_for_molecule(memory, ctx.state.file_hash(), [](const ChannelState& old) {
    ChannelState fresh;
    fresh.balls_key = old.balls_key;  // no two sets of balls may share a key
    return fresh;
  });
  if (!ctx.state.has_molecule() || !ctx.state.references ||
      ctx.state.references->prepared().balls->size() == 0) {
    return false;
  }
  take_balls(ctx, memory);
  return true;
}

Derived<FoundWays> want_ways(PanelContext& ctx, const ChannelState& memory) {
  return ctx.store.want(found_ways(), inputs_as_they_are(memory));
}

void take_found_channel(const PanelContext& ctx, ChannelState& memory,
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

std::unique_ptr<Panel> channels_panel() {
  return panel_of(draw_channels);
}

}  // namespace alphascope
