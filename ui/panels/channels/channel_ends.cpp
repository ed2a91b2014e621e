// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that choose where a channel begins and ends, and the question that follows from them.
#include <algorithm>
#include <cmath>

#include "core/document/channels/channel_results.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/channels/channel_parts.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kFrom[] = {"the selected cavity",
                                 "a mouth of the cavity",
                                 "the selected atoms",
                                 "the molecule's middle",
                                 "a point",
                                 "outside: all ways through"};
constexpr const char* kFromHelp[] = {
    "The widest place of the cavity that is selected on the page Cavities.",
    "The widest place in one mouth of the selected cavity.",
    "The centre of the atoms that are selected in the view.",
    "The centre of all balls.",
    "Coordinates in Å, as in the file.",
    ("From outside to outside: ways through the whole molecule, through groups of equal chains, "
     "and "
     "through each chain.")};
constexpr const char* kTo[] = {"outside, by any way", "outside, one way along", "both ways along",
                               "a mouth of the cavity", "a point"};
constexpr const char* kToHelp[] = {
    "The widest of all ways out of the molecule.",
    "Out of the molecule, without going back behind the plane through the start.",
    "Through a pore: out at both its ends. The start first moves to the middle of the pore.",
    "The widest place in one mouth of the selected cavity.", "Coordinates in Å, as in the file."};
constexpr const char* kAxes[] = {"the main axis", "x", "y", "z", "the line of sight"};

// Draws a list of choices. Returns whether an entry was clicked, even the one already chosen.
template <class Choice, std::size_t N>
bool combo(PanelContext& ctx, const char* name, const char* const (&labels)[N],
           const char* const (&help)[N], Choice& chosen, float width) {
  const auto now = static_cast<std::size_t>(chosen);
  ImGui::SetNextItemWidth(ctx.px(width));
  const bool open = list_field(ctx, name, labels[now], ImGuiComboFlags_HeightLarge);
  if (!open) {
    tooltip(ctx, help[now]);
    return false;
  }
  bool clicked = false;
  for (std::size_t n = 0; n < N; ++n) {
    if (ImGui::Selectable(labels[n], n == now)) {
      chosen = static_cast<Choice>(n);
      clicked = true;
    }
    record(ctx, (std::string(name) + "." + std::to_string(n)).c_str());
    tooltip(ctx, help[n]);
  }
  ImGui::EndCombo();
  return clicked;
}

void point_fields(PanelContext& ctx, const std::string& name, RealPoint& point) {
  static constexpr NumberRule kRules[] = {
      {"x", -1e6, 1e6, "Å"}, {"y", -1e6, 1e6, "Å"}, {"z", -1e6, 1e6, "Å"}};
  double* const values[] = {&point.x, &point.y, &point.z};
  for (std::size_t n = 0; n < 3; ++n) {
    if (n > 0) ImGui::SameLine(0, ctx.px(4));
    ImGui::SetNextItemWidth(ctx.px(58));
    const std::string field = name + "." + kRules[n].name;
    number_field(ctx, field.c_str(), *values[n], kRules[n]);
    tooltip(ctx, (std::string(kRules[n].name) + " in Å, as in the file.").c_str());
  }
}

// Rounds a point to 0.001 Å, as a user would type it.
RealPoint to_type(const RealPoint& p) {
  const auto rounded = [](double value) { return std::round(1000 * value) / 1000; };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

void mouth_field(PanelContext& ctx, const char* name, int& mouth) {
  static constexpr NumberRule kRule{"The number of the mouth", 1, 100000, "", true};
  ImGui::SetNextItemWidth(ctx.px(48));
  number_field(ctx, name, mouth, kRule);
  tooltip(ctx, "Mouths are numbered from 1.");
}

void axis_choice(PanelContext& ctx, ChannelState& memory) {
  static constexpr const char* kHelp[] = {
      ("The axis around which equal chains are arranged. Without one: the direction in which "
       "the molecule is longest."),
      "The x axis of the file.", "The y axis of the file.", "The z axis of the file.",
      "The present direction of view. Turning the view later does not change it."};
  const bool clicked = combo(ctx, "channels.axis", kAxes, kHelp, memory.axis, 116);
  if (clicked && memory.axis == ChannelAxis::view) {
    memory.view_axis = ctx.state.viewport.into_view;
  }
  if (memory.to != ChannelTo::along) return;
  ImGui::SameLine(0, ctx.px(6));
  if (button(ctx, "channels.turn", memory.backwards ? "−" : "+")) {
    memory.backwards = !memory.backwards;
  }
  tooltip(ctx, "Along the direction, or against it.");
}

void label(PanelContext& ctx, const char* text) {
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, text);
  ImGui::SameLine(ctx.px(42));
}

// --- the question

RealPoint axis_of(const ChannelState& memory) {
  switch (memory.axis) {
    case ChannelAxis::x:
      return {1, 0, 0};
    case ChannelAxis::y:
      return {0, 1, 0};
    case ChannelAxis::z:
      return {0, 0, 1};
    case ChannelAxis::view:
      return memory.view_axis;
    case ChannelAxis::main:
      break;
  }
  return memory.main_axis.axis;
}

// A place, or the reason why there is none.
struct Place {
  std::optional<RealPoint> at;
  ChannelRequest none;
};

Place no_place(const std::string& why, bool waiting = false) {
  Place place;
  place.none.why = why;
  place.none.waiting = waiting;
  return place;
}

Place centre_of_selection(const PanelContext& ctx) {
  const BallReferences& atoms = *ctx.state.references;
  const BallSet& balls = *atoms.prepared().balls;
  RealPoint sum;
  std::size_t count = 0;
  for (const Ref& ref : ctx.state.settings.selection.items.items()) {
    const auto found = atoms.balls(ref);
    if (!found) continue;
    for (const BallIndex ball : *found) {
      sum = sum + real_point(balls.centres[ball]);
      ++count;
    }
  }
  if (count == 0) {
    return no_place("Select atoms around the channel: click them in the view, Ctrl+click adds.");
  }
  return {(balls.lattice.unit_angstrom() / static_cast<double>(count)) * sum, {}};
}

template <class T>
Place not_yet(const Derived<T>& cavities) {
  if (cavities.state == DerivedState::failed || cavities.state == DerivedState::no_room) {
    return no_place("The cavities are not known. " + cavities.why);
  }
  return no_place("The cavities are being computed.", true);
}

// Returns the widest place in the chosen cavity (`mouth` 0) or in one of its mouths, from 1.
Place of_cavity(PanelContext& ctx, int mouth) {
  const auto& chosen = ctx.state.cavities.chosen;
  if (!ctx.state.settings.selection.cavities.empty()) {
    const FollowedCavities followed = follow_cavities(ctx);
    if (!followed.current) return not_yet(followed.wanted);
  }
  if (chosen.empty()) {
    Place place = no_place("Select a cavity: click its row on the page Cavities.");
    place.none.wants_cavity = true;
    return place;
  }
  const auto balls = ctx.state.references->balls(Ref(chosen.back()));
  if (!balls || balls->size() != 4) {
    return no_place("The selected cavity has atoms that are left out now. Select a cavity again.");
  }
  const std::array<BallIndex, 4> sink{(*balls)[0], (*balls)[1], (*balls)[2], (*balls)[3]};
  const Derived<FoundCavityEnds> ends = ctx.store.want(cavity_ends(sink), ctx.inputs);
  if (!ends.ready()) return not_yet(ends);
  if (!ends.value->found) {
    return no_place(
        "The selected cavity does not exist at this alpha and solvent radius. Select another "
        "one on the page Cavities.");
  }
  const CavityEnds& found = *ends.value->found;
  if (mouth == 0) return {found.widest.place_angstrom, {}};
  const std::size_t mouths = found.mouths.size();
  if (static_cast<std::size_t>(mouth) > mouths) {
    return no_place(mouths == 0 ? "The selected cavity has no mouth."
                                : "The selected cavity has " + std::to_string(mouths) +
                                      (mouths == 1 ? " mouth" : " mouths") + ", and no mouth " +
                                      std::to_string(mouth) + ".");
  }
  return {found.mouths[static_cast<std::size_t>(mouth) - 1].place_angstrom, {}};
}

Place start_of(PanelContext& ctx, const ChannelState& memory) {
  switch (memory.from) {
    case ChannelFrom::cavity:
      return of_cavity(ctx, 0);
    case ChannelFrom::mouth:
      return of_cavity(ctx, memory.from_mouth);
    case ChannelFrom::atoms:
      return centre_of_selection(ctx);
    case ChannelFrom::middle:
      return {memory.main_axis.middle_angstrom, {}};
    case ChannelFrom::point:
    case ChannelFrom::ways:
      break;
  }
  return {memory.from_point, {}};
}

}  // namespace

void draw_channel_ends(PanelContext& ctx, ChannelState& memory) {
  const ChannelFrom from = memory.from;
  const ChannelTo to = memory.to;
  const auto beside = [&] { ImGui::SameLine(0, ctx.px(6)); };
  label(ctx, "From");
  combo(ctx, "channels.from", kFrom, kFromHelp, memory.from, 170);
  // The fields begin with the start of the last channel, so the user can move the point from there.
  if (memory.from != from && memory.from == ChannelFrom::point) {
    memory.from_point = to_type(memory.last_from);
  }
  if (memory.from == ChannelFrom::point) {
    beside();
    point_fields(ctx, "channels.from", memory.from_point);
  } else if (memory.from == ChannelFrom::mouth) {
    beside();
    mouth_field(ctx, "channels.from.mouth", memory.from_mouth);
  }
  if (memory.from == ChannelFrom::ways) return;
  label(ctx, "To");
  combo(ctx, "channels.to", kTo, kToHelp, memory.to, 170);
  if (memory.to != to && memory.to == ChannelTo::point) memory.to_point = to_type(memory.last_from);
  if (memory.to == ChannelTo::along || memory.to == ChannelTo::both_ways) {
    beside();
    axis_choice(ctx, memory);
  } else if (memory.to == ChannelTo::point) {
    beside();
    point_fields(ctx, "channels.to", memory.to_point);
  } else if (memory.to == ChannelTo::mouth) {
    beside();
    mouth_field(ctx, "channels.to.mouth", memory.to_mouth);
  }
}

ChannelRequest channel_request(PanelContext& ctx, ChannelState& memory) {
  const Place start = start_of(ctx, memory);
  if (!start.at) return start.none;
  memory.last_from = *start.at;
  const RealPoint axis = axis_of(memory);
  ChannelRequest question;
  switch (memory.to) {
    case ChannelTo::out:
      question.ends = ChannelEnds::out(*start.at);
      break;
    case ChannelTo::along:
      question.ends = ChannelEnds::out_along(*start.at, memory.backwards ? -1.0 * axis : axis);
      break;
    case ChannelTo::both_ways:
      question.ends = ChannelEnds::through(*start.at, axis);
      break;
    case ChannelTo::mouth: {
      const Place end = of_cavity(ctx, memory.to_mouth);
      if (!end.at) return end.none;
      question.ends = ChannelEnds::between(*start.at, *end.at);
      break;
    }
    case ChannelTo::point:
      question.ends = ChannelEnds::between(*start.at, memory.to_point);
      break;
  }
  return question;
}

}  // namespace alphascope
