// SPDX-License-Identifier: GPL-3.0-or-later
// The section “Objects”: all that the picture shows, a line each, with an eye, an opacity and, for
// objects of atoms, their settings.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/document/commands/number_input.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/selection/selection_expression.hpp"
#include "ui/panels/complex/display_rows.hpp"
#include "ui/panels/complex/objects_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/rgb8.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/colour_field.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

using D = DisplaySettings;

constexpr float kSlider = 110, kButton = 24;  // pixels at scale 1

// A button with an eye, which is closed while the thing is hidden.
void eye(PanelContext& ctx, const std::string& name, const std::string& what, bool& shown) {
  const float size = ImGui::GetFrameHeight();
  if (button(ctx, name.c_str(), ("##" + name).c_str(), {size, size}, ButtonKind::quiet)) {
    shown = !shown;
  }
  tooltip(ctx, ((shown ? "Hide: " : "Show: ") + what).c_str());
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 ink = to_u32(shown ? ctx.palette.text : ctx.palette.text_muted);
  const float w = 0.30F * size, h = 0.22F * size, line = std::max(1.0F, 0.055F * size);
  const ImVec2 left{middle.x - w, middle.y}, right{middle.x + w, middle.y};
  const float bend = 1.9F * h;
  draw->AddBezierQuadratic(left, {middle.x, middle.y + bend}, right, ink, line);
  if (!shown) return;
  draw->AddBezierQuadratic(left, {middle.x, middle.y - bend}, right, ink, line);
  draw->AddCircleFilled(middle, 0.11F * size, ink);
}

// The slider ends `kButton` pixels before the end of the line, where objects have a button. The
// number is the opacity in the picture, which a page may have lowered.
void opacity(PanelContext& ctx, const std::string& name, float line_end, float& value) {
  constexpr NumberRule kRule{"The opacity", 100 * kLeastOpacity, 100, "%"};
  ImGui::SameLine(line_end - ctx.px(kSlider + kButton));
  double percent = std::round(100.0 * value);
  const std::string set = percent_text(value), shown = percent_text(shown_opacity(ctx, value));
  const bool faded = shown != set;
  if (faded) ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  if (value_slider(ctx, name.c_str(), percent, kRule.least, kRule.most, kRule, shown, kButton)) {
    value = static_cast<float>(percent / 100);
  }
  if (faded) ImGui::PopStyleColor();
  const std::string help = "Opacity. Ctrl+click to type a number.";
  tooltip(ctx, (faded ? help + " It is set to " + set +
                            ", but the page below fades the picture to " + shown + "."
                      : help)
                   .c_str());
}

// Whether a page fades anything of the list.
bool fades_any(const PanelContext& ctx) {
  const D& d = ctx.state.settings.display;
  const auto fades = [&](double opacity) { return shown_opacity(ctx, opacity) < opacity; };
  const DrawnObjects& objects = ctx.state.settings.objects;
  return (d.balls && fades(d.ball_opacity)) || (d.tetrahedra && fades(d.complex_opacity)) ||
         std::any_of(objects.begin(), objects.end(),
                     [&](const DrawnObject& o) { return o.shown && fades(o.opacity); });
}

// A line of balls or simplices, which have more settings in the section Display.
void line_of_display(PanelContext& ctx, float end, bool D::*shown, float D::*opaque) {
  D& d = ctx.state.settings.display;
  const DisplayField& field = display_field(shown);
  const std::string name = std::string("objects.") + field.id;
  eye(ctx, name, field.title, d.*shown);
  ImGui::SameLine(0, ctx.px(4));
  ImGui::AlignTextToFramePadding();
  d.*shown ? ImGui::TextUnformatted(field.title) : muted_text(ctx, field.title);
  if (opaque != nullptr) opacity(ctx, name + ".opacity", end, d.*opaque);
}

void colour_row(PanelContext& ctx, const std::string& name, DrawnObject& object) {
  row_label(ctx, "Colour by");
  if (list_field(ctx, (name + ".colour").c_str(), object_colour_info(object.colour).title)) {
    for (const ObjectColourInfo& info : object_colours()) {
      if (ImGui::Selectable(info.title, info.colour == object.colour)) object.colour = info.colour;
      record(ctx, (name + ".colour." + info.id).c_str());
    }
    ImGui::EndCombo();
  }
  if (object.colour != ObjectColour::single) return;
  row_label(ctx, "Colour");
  Colour now = to_colour(object.own);
  if (colour_field(ctx, name + ".own", now)) object.own = to_rgb8(now);
}

void kind_row(PanelContext& ctx, const std::string& name, DrawnObject& object) {
  row_label(ctx, "Drawn as");
  if (!list_field(ctx, (name + ".kind").c_str(), object_kind_info(object.kind).title)) return;
  for (const ObjectKindInfo& info : object_kinds()) {
    if (ImGui::Selectable(info.title, info.kind == object.kind)) object.kind = info.kind;
    tooltip(ctx, info.help);
    record(ctx, (name + ".kind." + info.id).c_str());
  }
  ImGui::EndCombo();
}

void atoms_row(PanelContext& ctx, const std::string& name, ObjectsState& memory,
               DrawnObject& object) {
  row_label(ctx, "Atoms");
  if (memory.shown != object.atoms) memory.typed = memory.shown = object.atoms;
  ImGui::SetNextItemWidth(-1);
  const bool entered = text_field(ctx, (name + ".atoms").c_str(), memory.typed, "all atoms");
  tooltip(ctx, "An expression, such as ligand, chain A or within 5 of ligand. Enter applies it.");
  if (ImGui::IsItemEdited()) memory.error.clear();
  if (entered) {
    const auto fault = fault_of_selection(memory.typed);
    memory.error = fault ? fault->what() : "";
    if (!fault) object.atoms = memory.shown = memory.typed;
  }
  if (memory.error.empty()) return;
  row_label(ctx, "");
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.error));
  wrapped_text(memory.error);
  ImGui::PopStyleColor();
  record(ctx, (name + ".error").c_str());
}

// A small triangle that points right, or down if the settings below are open.
void draw_arrow(PanelContext& ctx, ImVec2 corner, bool open) {
  const float half = ImGui::GetFrameHeight() / 2, size = ctx.px(3.5F);
  const ImVec2 at{corner.x + ctx.px(6), corner.y + half};
  const ImU32 ink = to_u32(ctx.palette.text_muted);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (open) {
    draw->AddTriangleFilled({at.x - size, at.y - 0.6F * size}, {at.x + size, at.y - 0.6F * size},
                            {at.x, at.y + size}, ink);
  } else {
    draw->AddTriangleFilled({at.x - 0.6F * size, at.y - size}, {at.x + size, at.y},
                            {at.x - 0.6F * size, at.y + size}, ink);
  }
}

// Returns whether the object is to be removed.
bool line_of_object(PanelContext& ctx, float end, ObjectsState& memory, int n,
                    DrawnObject& object) {
  const std::string name = "objects." + std::to_string(n + 1);
  const std::string title = object_title(object);
  eye(ctx, name, title, object.shown);
  ImGui::SameLine(0, ctx.px(4));
  const float room = end - ctx.px(kSlider + kButton + 6) - ImGui::GetCursorPosX();
  const bool open = memory.open == n;
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  const float arrow = ctx.px(15);
  const std::string label = fitted_text(title, room - arrow) + "##" + name;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + arrow);
  if (button(ctx, (name + ".title").c_str(), label.c_str(), {room - arrow, 0}, ButtonKind::quiet)) {
    memory = {};
    memory.open = open ? -1 : n;
  }
  ImGui::PopStyleVar(2);
  draw_arrow(ctx, corner, open);
  tooltip(ctx, (title + "\nClick for its atoms and colours.").c_str());
  opacity(ctx, name + ".opacity", end, object.opacity);
  ImGui::SameLine(end - ctx.px(kButton - 2));
  const bool remove = button(ctx, (name + ".remove").c_str(), ("×##" + name).c_str(),
                             {ctx.px(kButton - 2), 0}, ButtonKind::quiet);
  tooltip(ctx, ("Remove: " + title).c_str());
  if (memory.open == n && !remove) {
    ImGui::Indent();
    kind_row(ctx, name, object);
    atoms_row(ctx, name, memory, object);
    colour_row(ctx, name, object);
    ImGui::Unindent();
  }
  return remove;
}

// Objects that people ask for most.
struct Offer {
  const char* title;
  const char* text;  // as for read_object()
};
constexpr Offer kOffers[] = {{"Cartoon", "cartoon"},
                             {"Cartoon, helices and strands", "cartoon,secondary"},
                             {"Ligands as sticks", "sticks:ligand"},
                             {"Ligands as balls and sticks", "balls_and_sticks:ligand"},
                             {"Side chains within 5 Å of ligands",
                              "sticks:byres within 5 of ligand and not ligand and polymer"},
                             {"All bonds as sticks", "sticks"},
                             {"Waters and ions", "balls_and_sticks:water or ion"},
                             {"All atoms as points", "points"}};

void add_row(PanelContext& ctx, ObjectsState& memory, DrawnObjects& objects) {
  ImGui::BeginDisabled(!ctx.state.has_molecule() || objects.size() >= kMostObjects);
  ImGui::SetNextItemWidth(-1);
  if (list_field(ctx, "objects.add", "Add…", ImGuiComboFlags_HeightLarge)) {
    for (const Offer& offer : kOffers) {
      if (ImGui::Selectable(offer.title)) {
        objects.push_back(read_object(offer.text).object);
        memory = {};
        memory.open = static_cast<int>(objects.size()) - 1;
      }
      record(ctx, ("objects.add." + std::to_string(&offer - kOffers)).c_str());
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
}

void draw_objects(PanelContext& ctx, ObjectsState& memory) {
  if (!section(ctx, "objects", "Objects")) return;
  DrawnObjects& objects = ctx.state.settings.objects;
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  line_of_display(ctx, end, &D::balls, &D::ball_opacity);
  line_of_display(ctx, end, &D::tetrahedra, &D::complex_opacity);
  std::optional<std::size_t> removed;
  for (std::size_t n = 0; n < objects.size(); ++n) {
    if (line_of_object(ctx, end, memory, static_cast<int>(n), objects[n])) removed = n;
  }
  if (removed) {
    objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(*removed));
    memory = {};
  }
  if (fades_any(ctx)) fading_note(ctx, "objects.faded");
  add_row(ctx, memory, objects);
}

}  // namespace

std::unique_ptr<Panel> objects_panel() {
  return panel_of<ObjectsState>(draw_objects);
}

}  // namespace alphascope
