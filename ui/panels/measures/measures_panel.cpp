// SPDX-License-Identifier: GPL-3.0-or-later
// The page of measures: exact areas and volumes of the complex on screen. It has totals and a table
// by component, chain, residue or atom, which sorts, filters and selects.
#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/measures/measure_rows.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/document/tables/cell_value.hpp"
#include "ui/panels/measures/measure_parts.hpp"
#include "ui/panels/measures/measure_state.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

constexpr MeasureGrouping kPer[] = {MeasureGrouping::component, MeasureGrouping::chain,
                                    MeasureGrouping::residue, MeasureGrouping::atom};
constexpr const char* kPlural[] = {"components", "chains", "residues", "atoms"};

struct Total {
  const char* name;  // of the widget
  std::string text;
  const char* help;
};

std::vector<Total> totals_of(const MeasuredComplex& measured) {
  const UnionMeasures& m = measured.measures();
  const std::uint32_t parts = measured.components.count;
  return {{"measures.area", "area " + measure_text(m.area_angstrom2()) + " Å²",
           "Exact surface area of the union of all balls, including the surfaces of voids."},
          {"measures.volume", "volume " + measure_text(m.volume_angstrom3()) + " Å³",
           "Exact volume of the union of all balls."},
          {"measures.arcs", "arcs " + measure_text(m.total[MeasuredQuantity::arc_length]) + " Å",
           "Exact length of the arcs on the surface in which two spheres meet."},
          {"measures.components", number(parts) + (parts == 1 ? " component" : " components"),
           "Number of connected components. Overlapping balls belong to one component."}};
}

// Goes to a line of its own if the rest of this one is too short for all totals and the surface.
void make_room(PanelContext& ctx, const std::vector<Total>& totals, float gap,
               const std::string& surface) {
  float wanted = ImGui::CalcTextSize(surface.c_str()).x;
  ImGui::PushFont(ctx.fonts.strong);
  for (const Total& total : totals) wanted += ImGui::CalcTextSize(total.text.c_str()).x + gap;
  ImGui::PopFont();
  const bool begun = ImGui::GetCursorPosX() > ImGui::GetCursorStartPos().x + 1;
  if (begun && ImGui::GetContentRegionAvail().x < wanted) ImGui::NewLine();
}

void totals_line(PanelContext& ctx, const MeasureState& memory) {
  const std::vector<Total> totals = totals_of(*memory.measured);
  const float gap = ctx.px(16);
  make_room(ctx, totals, gap, memory.surface);
  for (const Total& total : totals) {
    ImGui::AlignTextToFramePadding();
    strong_text(ctx, total.text);
    record(ctx, total.name);
    tooltip(ctx, total.help);
    ImGui::SameLine(0, gap);
  }
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(memory.surface, ImGui::GetContentRegionAvail().x));
  record(ctx, "measures.surface");
  tooltip(ctx,
          "Alpha and solvent radius choose the surface. Both 0: van der Waals surface. Alpha 0 and "
          "solvent radius 1.4 Å (water): solvent-accessible surface.");
}

std::string shown_text(const MeasureState& memory) {
  const MeasureRows& rows = *memory.rows;
  std::string text = number(rows.rows.size());
  if (rows.rows.size() < rows.all) text += " of " + number(rows.all);
  const auto per = std::find(std::begin(kPer), std::end(kPer), rows.query.per) - std::begin(kPer);
  text += std::string(" ") + kPlural[per];
  if (!memory.chosen.empty()) text += ", " + number(memory.chosen.size()) + " selected";
  return text;
}

// Says how long measuring took and on which device. If it should have been a GPU and was not, says
// why.
std::string measured_text(const MeasuredUnion& by) {
  std::string text = "Measured in " + milliseconds_text(by.milliseconds) + " on " + by.device;
  if (!by.route.empty()) text += ": " + by.route;
  return text + "." + (by.note.empty() ? "" : "\n" + by.note);
}

void controls_line(PanelContext& ctx, MeasureState& memory) {
  const int before = memory.per;
  choice(ctx, "measures.per", {"components", "chains", "residues", "atoms"}, memory.per,
         ctx.px(340));
  if (memory.per != before) memory.chosen.clear();
  const float gap = ctx.px(12), field = ctx.px(130);
  same_line_where_it_fits(field, gap);
  ImGui::SetNextItemWidth(field);
  text_field(ctx, "measures.filter", memory.query.filter, "name contains…");
  same_line_where_it_fits(checkbox_width("Changes"), gap);
  ImGui::BeginDisabled(kPer[memory.per] != MeasureGrouping::atom);
  checkbox(ctx, "measures.changes", "Changes", memory.changes);
  ImGui::EndDisabled();
  tooltip(
      ctx,
      "Shows how area and volume change when an atom moves or grows. Available for rows of atoms.");
  same_line_where_it_fits(button_width("Copy CSV") + button_width("Save…") + ctx.px(4), gap);
  measure_save_buttons(ctx, memory);
  if (!memory.rows) return;
  const std::string text = shown_text(memory);
  same_line_where_it_fits(ImGui::CalcTextSize(text.c_str()).x, gap);
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "measures.shown");
  tooltip(ctx, (text + "\n" + measured_text(*memory.measured->by)).c_str());
}

// Says why there are no numbers yet.
std::string waiting_text(const PanelContext& ctx, const Derived<MeasuredComplex>& measured) {
  if (!ctx.state.has_molecule()) return "Open a molecule: its area and volume appear here.";
  const AlphaComplex* complex = ctx.inputs.complex.get();
  if (complex && complex->tetrahedra_only) {
    return "Areas and volumes need all simplices. Switch “Tetrahedra only” off in the section "
           "Engine.";
  }
  if (measured.state == DerivedState::no_room || measured.state == DerivedState::failed) {
    return "There are no areas and volumes. " + measured.why;
  }
  return "The complex is still being computed. Area and volume appear here afterwards.";
}

void say_why_none(PanelContext& ctx, const Derived<MeasuredComplex>& measured) {
  muted_wrapped(ctx, waiting_text(ctx, measured));
  record(ctx, "measures.waiting");
}

// Whether the rows belong to the picture. They may still be sorted or filtered in another way.
bool of_the_picture(const Derived<MeasureRows>& rows) {
  return rows.value && rows.have.balls == rows.wanted.balls && rows.have.alpha == rows.wanted.alpha;
}

void take_measures(PanelContext& ctx, MeasureState& memory,
                   const Derived<MeasuredComplex>& measured) {
  if (!measured.ready() || memory.measured == measured.value) return;
  memory.measured = measured.value;
  memory.surface = surface_name(*ctx.state.shown_request());
}

void draw_measures(PanelContext& ctx, MeasureState& memory) {
  reset_for_molecule(memory, ctx.state.file_hash());
  ctx.state.measures_wanted = true;
  const bool whole = !ctx.inputs.complex || !ctx.inputs.complex->tetrahedra_only;
  Derived<MeasuredComplex> measured;
  Derived<MeasureRows> rows;
  if (shows_these_balls(ctx) && whole) {
    measured = ctx.store.want(union_measures(), ctx.inputs);
    take_measures(ctx, memory, measured);
    memory.query.per = kPer[memory.per];
    memory.query.derivatives = memory.changes;
    rows = ctx.store.want(measure_rows(memory.query, ctx.state.result), ctx.inputs);
    if (of_the_picture(rows)) memory.rows = rows.value;
    if (memory.copying && ctx.inputs.atoms) copy_measures_when_there(ctx, memory);
  }
  if (!memory.measured || !whole) return say_why_none(ctx, measured);
  // Numbers that do not belong to the picture are grey.
  const bool current = measured.ready() && of_the_picture(rows);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, measured.ready() ? 1.0f : 0.55f);
  totals_line(ctx, memory);
  ImGui::PopStyleVar();
  controls_line(ctx, memory);
  if (!memory.rows) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, current ? 1.0f : 0.55f);
  draw_measure_table(ctx, memory, current ? ctx.state.references.get() : nullptr);
  ImGui::PopStyleVar();
}

}  // namespace

bool shows_these_balls(const PanelContext& ctx) {
  const auto& atoms = ctx.state.references;
  return ctx.state.shown_balls() && atoms && ctx.inputs.complex &&
         ctx.state.shown_balls() == ctx.inputs.balls &&
         &atoms->prepared() == ctx.state.shown_selection();
}

std::unique_ptr<Panel> measures_panel() {
  return panel_of(draw_measures);
}

}  // namespace alphascope
