// SPDX-License-Identifier: GPL-3.0-or-later
// The section on the clip: a plane or a slab, its position, and the handle in the picture that
// moves and turns it.
#include "ui/panels/complex/clip_panel.hpp"
#include "ui/panels/panel.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/commands/commands.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/settings/clip.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/real_point.hpp"
#include "ui/clip_handle.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/number_typing.hpp"

namespace alphascope {
namespace {

using Vector = std::array<double, 3>;

// Pixels at scale 1; the mouse takes the handle within this distance.
constexpr float kHandleReach = 6;
constexpr double kSliderStep = 0.1;  // Å; typed values are not rounded

Vector towards_viewer(const ViewState& state) {
  const RealPoint& into = state.viewport.into_view;
  return {-into.x, -into.y, -into.z};
}

double stepped(double value) {
  const double rounded = std::round(value / kSliderStep) * kSliderStep;
  return rounded == 0 ? 0 : rounded;  // avoids "-0.0" in the text
}

void kind_row(PanelContext& ctx) {
  int kind = static_cast<int>(ctx.state.settings.clip.kind);
  if (choice(ctx, "clip.kind", {"Off", "Plane", "Slab"}, kind, ImGui::GetContentRegionAvail().x)) {
    set_clip_kind(ctx.state, static_cast<Clip::Kind>(kind));
  }
}

void across_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  row_label(ctx, "Across");
  const std::string name = axis_name(s.settings.clip.normal);
  const std::string axes = "xyz";
  const std::size_t axis = name.empty() ? std::string::npos : axes.find(name.back());
  int chosen = !s.settings.clip.on() || axis == std::string::npos ? -1 : static_cast<int>(axis);
  if (!choice(ctx, "clip.across", {"X", "Y", "Z", "View"}, chosen,
              ImGui::GetContentRegionAvail().x)) {
    return;
  }
  Vector normal{};
  if (chosen < 3) normal[static_cast<std::size_t>(chosen)] = 1;
  set_clip_across(s, chosen < 3 ? normal : towards_viewer(s));
}

// A row for a length. A slider changes it in steps, and the user may type any value.
void length_row(PanelContext& ctx, const char* name, const char* label, double& length,
                const std::array<double, 2>& range, const NumberRule& rule) {
  row_label(ctx, label);
  double value = length;
  const bool typing = ctx.state.number.name == name;
  const double low = std::min(range[0], value), high = std::max(range[1], value);
  const std::string text = number_text(value, 1) + " Å";
  if (value_slider(ctx, name, value, low, high, rule, text)) {
    length = typing ? value : std::max(rule.least, stepped(value));
  }
  tooltip(ctx, "In Å. Ctrl+click to type.");
}

}  // namespace

std::array<double, 2> clip_range(const ViewState& state) {
  const ViewportInfo& v = state.viewport;
  double middle = 0, reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    middle += state.settings.clip.normal[k] * v.box_middle[k];
    reach += std::fabs(state.settings.clip.normal[k]) * v.box_half[k];
  }
  return {middle - reach, middle + reach};
}

void set_clip_kind(ViewState& state, Clip::Kind kind) {
  const bool first = state.settings.clip == Clip{};
  state.settings.clip.kind = kind;
  if (first && kind != Clip::Kind::off) set_clip_across(state, towards_viewer(state));
}

void set_clip_across(ViewState& state, const Vector& normal) {
  state.settings.clip = turned(state.settings.clip, normal, state.viewport.box_middle);
}

namespace {

// Saved clips: a list to choose from, and buttons that ask for a name.
void saved_row(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const NamedClips& clips = s.settings.clips;
  row_label(ctx, "Saved");
  std::string chosen = clips.empty() ? "none" : "choose";
  for (const NamedClip& saved : clips) {
    if (saved.clip == s.settings.clip) chosen = saved.name;
  }
  ImGui::BeginDisabled(clips.empty());
  if (list_field(ctx, "clip.saved", chosen.c_str())) {
    for (std::size_t i = 0; i < clips.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::Selectable(clips[i].name.c_str(), clips[i].clip == s.settings.clip)) {
        s.settings.clip = clips[i].clip;
      }
      ImGui::PopID();
      record(ctx, ("clip.saved." + clips[i].name).c_str());
      tooltip(ctx, clip_text(clips[i].clip).c_str());
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ctx.px(6)) / 3;
  const auto ask = [&](const char* name, const char* label, bool can, const char* command,
                       const char* help) {
    ImGui::BeginDisabled(!can);
    if (button(ctx, name, label, {width, 0})) s.palette = {.show = true, .asking = command};
    ImGui::EndDisabled();
    tooltip(ctx, help);
  };
  ask("clip.save", "Save…", s.settings.clip.on(), "view.save_clip",
      "Saves the present clip under a name.");
  ImGui::SameLine(0, ctx.px(6));
  ask("clip.rename", "Rename…", !clips.empty(), "view.rename_clip",
      "Gives a saved clip another name.");
  ImGui::SameLine(0, ctx.px(6));
  ask("clip.forget", "Forget…", !clips.empty(), "view.forget_clip",
      "Removes a saved clip; the picture stays cut.");
}

void draw_clip(PanelContext& ctx) {
  if (!section(ctx, "clip", "Clip")) return;
  ViewState& s = ctx.state;
  ImGui::BeginDisabled(!s.molecule.loaded);
  kind_row(ctx);
  // Rows that do not apply are greyed, not hidden, so that nothing below moves.
  ImGui::BeginDisabled(!s.settings.clip.on());
  across_row(ctx);
  length_row(ctx, "clip.position", "Position", s.settings.clip.position, clip_range(s),
             kClipPositionRule);
  const bool slab = s.settings.clip.kind == Clip::Kind::slab;
  const std::array<double, 2> range = clip_range(s);
  ImGui::BeginDisabled(!slab);
  length_row(ctx, "clip.thickness", "Thickness", s.settings.clip.thickness,
             {kClipThicknessRule.least, range[1] - range[0]}, kClipThicknessRule);
  ImGui::EndDisabled();
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ctx.px(6)) / 3;
  ImGui::BeginDisabled(slab);
  if (button(ctx, "clip.flip", "Flip", {width, 0}))
    s.settings.clip.flipped = !s.settings.clip.flipped;
  tooltip(ctx, "Keeps the other side of the plane.");
  ImGui::EndDisabled();
  ImGui::SameLine(0, ctx.px(6));
  if (button(ctx, "clip.face", "Look at it", {width, 0})) ctx.commands.run("view.clip_face");
  tooltip(ctx, "Turns the view to face the cut.");
  ImGui::SameLine(0, ctx.px(10));
  checkbox(ctx, "clip.handle", "Handle", s.window.clip_handle);
  tooltip(ctx, "In the picture: drag its arrow to move the cut, its ring to turn it.");
  ImGui::EndDisabled();
  saved_row(ctx);
  ImGui::EndDisabled();
}

}  // namespace

std::unique_ptr<Panel> clip_panel() {
  return panel_of(draw_clip);
}

bool clip_handle_mouse(PanelContext& ctx, ImVec2 corner, bool view_hovered) {
  ViewState& s = ctx.state;
  ViewportInfo& v = s.viewport;
  HandlePart& held = s.mouse.clip_part;
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseDown(0)) held = HandlePart::none;
  const PicturePoint mouse{io.MousePos.x - corner.x, io.MousePos.y - corner.y};
  const bool may = view_hovered && s.window.clip_handle && !s.mouse.dragging_view;
  s.mouse.clip_part_hovered = held;
  if (held == HandlePart::none && may) {
    s.mouse.clip_part_hovered = part_at(v.clip_handle, mouse, ctx.px(kHandleReach));
    if (ImGui::IsMouseClicked(0)) held = s.mouse.clip_part_hovered;
  }
  if (held != HandlePart::none) {
    s.settings.clip =
        dragged(s.settings.clip, v.clip_handle, held, {io.MouseDelta.x, io.MouseDelta.y});
  }
  return s.mouse.clip_part_hovered != HandlePart::none;
}

void draw_clip_handle(PanelContext& ctx) {
  const ClipHandle& h = ctx.state.viewport.clip_handle;
  if (!h.shown || !ctx.state.window.clip_handle || ctx.state.viewport.texture == 0) return;
  const ImVec2 corner = ImGui::GetWindowPos();
  const auto place = [&corner](const PicturePoint& p) {
    return ImVec2(corner.x + static_cast<float>(p[0]), corner.y + static_cast<float>(p[1]));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const HandlePart hovered = ctx.state.mouse.clip_part_hovered;
  const auto ink = [&](HandlePart part) {
    return to_u32(hovered == part ? ctx.palette.accent_hovered : ctx.palette.accent);
  };
  const ImU32 rim = to_u32(ctx.palette.scene, 0.7f);
  const auto line = [&](const PicturePoint& a, const PicturePoint& b, ImU32 colour, float width) {
    draw->AddLine(place(a), place(b), colour, ctx.px(width));
  };
  const float ring_width = hovered == HandlePart::turn ? 3.0f : 2.0f;
  for (const bool under : {true, false}) {
    for (std::size_t i = 1; i < h.ring.size(); ++i) {
      line(h.ring[i - 1], h.ring[i], under ? rim : ink(HandlePart::turn),
           under ? ring_width + 2 : ring_width);
    }
  }
  for (const bool under : {true, false}) {
    const ImU32 colour = under ? rim : ink(HandlePart::move);
    const float more = under ? 1.5f : 0.0f;
    line(h.middle, h.tip, colour, 3 + 2 * more);
    draw->AddCircleFilled(place(h.middle), ctx.px(5 + more), colour);
    draw->AddCircleFilled(place(h.tip), ctx.px(7 + more), colour);
  }
  const ImVec2 middle = place(h.middle);
  const float reach = ctx.px(kHandleReach);
  ctx.rects["view.clip_handle"] = {middle.x - reach, middle.y - reach, middle.x + reach,
                                   middle.y + reach, true};
  const ImVec2 on_ring = place(h.ring.front());
  ctx.rects["view.clip_ring"] = {on_ring.x - reach, on_ring.y - reach, on_ring.x + reach,
                                 on_ring.y + reach, true};
}

}  // namespace alphascope
