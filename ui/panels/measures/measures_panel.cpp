// SPDX-License-Identifier: GPL-3.0-or-later
// The page of measures: exact areas and volumes of the complex on screen. It has totals and a table
// by component, chain, residue or atom, which sorts, filters and selects.
#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/document/measures/measure_columns.hpp"
#include "core/document/measures/measure_records.hpp"
#include "core/document/store/store.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "ui/calls.hpp"
#include "ui/panels/dialogs/save_parts.hpp"
#include "ui/panels/measures/measure_state.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/panel.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/widgets/widgets.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/style.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"

namespace alphascope {
namespace {

std::string number(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

constexpr MeasureGrouping kPer[] = {MeasureGrouping::component, MeasureGrouping::chain,
                                    MeasureGrouping::residue, MeasureGrouping::atom};
constexpr const char* kPlural[] = {"components", "chains", "residues", "atoms"};

// --- columns

struct ColumnPlace {
  const char* id;
  float width;  // pixels at scale 1; 0: the remaining width
};
using Places = std::span<const ColumnPlace>;
constexpr ColumnPlace kPlaces[] = {
    {"number", 52},          {"name", 0},           {"atoms", 62},
    {"area_angstrom2", 92},  {"share_of_area", 68}, {"volume_angstrom3", 92},
    {"share_of_volume", 68}, {"exposed_share", 80}, {"arc_length_angstrom", 80}};
// Rows of atoms have no column for the number of atoms. Without it the derivatives have room.
constexpr ColumnPlace kPlacesWithDerivatives[] = {{"number", 52},
                                                  {"name", 0},
                                                  {"area_angstrom2", 92},
                                                  {"volume_angstrom3", 92},
                                                  {"exposed_share", 80},
                                                  {"area_by_shift_angstrom", 92},
                                                  {"area_by_radius_angstrom", 98},
                                                  {"volume_by_shift_angstrom2", 92},
                                                  {"volume_by_radius_angstrom2", 98}};

Places places_of(const MeasureRows& rows) {
  return rows.derivatives ? Places(kPlacesWithDerivatives) : Places(kPlaces);
}

const Column<MeasuredRow>& column_at(const ColumnPlace& place) {
  return column_of(measure_columns(), place.id);
}

// --- choosing

bool is_chosen(const MeasureState& memory, const AtomRef& first) {
  return std::find(memory.chosen.begin(), memory.chosen.end(), first) != memory.chosen.end();
}

void choose(MeasureState& memory, const AtomRef& first, bool add) {
  const auto at = std::find(memory.chosen.begin(), memory.chosen.end(), first);
  if (!add) {
    memory.chosen = {first};
  } else if (at != memory.chosen.end()) {
    memory.chosen.erase(at);
  } else {
    memory.chosen.push_back(first);
  }
}

// Makes the atoms of the chosen rows the selection, and moves the camera there.
void select_chosen(PanelContext& ctx, const MeasureState& memory, const BallReferences& atoms) {
  const std::vector<std::uint32_t>& group = memory.rows->group_of_ball;
  std::vector<std::uint32_t> groups;
  for (const AtomRef& first : memory.chosen) {
    const std::optional<BallIndex> ball = atoms.ball(first);
    if (ball && group[*ball] != kNoGroup) groups.push_back(group[*ball]);
  }
  std::sort(groups.begin(), groups.end());
  std::vector<Ref> refs;
  for (std::size_t ball = 0; ball < group.size() && refs.size() < Selection::kMostItems; ++ball) {
    if (std::binary_search(groups.begin(), groups.end(), group[ball])) {
      refs.push_back(atoms.atom(static_cast<BallIndex>(ball)));
    }
  }
  if (refs.size() == Selection::kMostItems) {
    ctx.state.notice = "Only the first " + number(Selection::kMostItems) + " atoms are selected.";
  }
  ctx.state.settings.selection.items = RefSet(std::move(refs));
  if (!memory.chosen.empty()) ctx.calls.view.zoom_to_selection();
}

// --- drawing

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

// Whether the complex on screen, the inputs and the references belong to the same balls.
bool fits(const PanelContext& ctx) {
  const auto& answer = ctx.state.result;
  const auto& atoms = ctx.state.references;
  return answer && atoms && ctx.inputs.complex && answer->balls == ctx.inputs.balls &&
         &atoms->prepared() == answer->prepared.get();
}

void save_button(PanelContext& ctx, const MeasureState& memory) {
  ImGui::BeginDisabled(!memory.rows || !ctx.inputs.atoms || !fits(ctx));
  if (button(ctx, "measures.save", "Save…")) {
    const RecordSource source = source_on_screen(ctx);
    open_save_dialog(ctx, {"Areas and volumes", file_name_for(ctx, "measures"),
                           measure_csv(memory.query, source, ctx.state.result),
                           measure_json(memory.query, source, ctx.state.result), ctx.inputs});
  }
  ImGui::EndDisabled();
  tooltip(ctx, "Saves the listed rows as CSV or JSON.");
}

void controls_line(PanelContext& ctx, MeasureState& memory) {
  const int before = memory.per;
  choice(ctx, "measures.per", {"components", "chains", "residues", "atoms"}, memory.per,
         ctx.px(340));
  if (memory.per != before) memory.chosen.clear();
  ImGui::SameLine(0, ctx.px(12));
  ImGui::SetNextItemWidth(ctx.px(130));
  text_field(ctx, "measures.filter", memory.query.filter, "name contains…");
  ImGui::SameLine(0, ctx.px(12));
  ImGui::BeginDisabled(kPer[memory.per] != MeasureGrouping::atom);
  checkbox(ctx, "measures.changes", "Changes", memory.changes);
  ImGui::EndDisabled();
  tooltip(
      ctx,
      "Shows how area and volume change when an atom moves or grows. Available for rows of atoms.");
  ImGui::SameLine(0, ctx.px(12));
  if (button(ctx, "measures.copy", "Copy CSV")) memory.copying = true;
  tooltip(ctx, "Copies the listed rows with all digits and their provenance.");
  ImGui::SameLine(0, ctx.px(4));
  save_button(ctx, memory);
  ImGui::SameLine(0, ctx.px(12));
  if (!memory.rows) return ImGui::NewLine();
  ImGui::AlignTextToFramePadding();
  const std::string text = shown_text(memory);
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "measures.shown");
  tooltip(ctx, (text + "\n" + measured_text(*memory.measured->by)).c_str());
}

void heading(PanelContext& ctx, Places places) {
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const ColumnPlace& place : places) {
    const std::string title = column_at(place).heading();
    ImGuiTableColumnFlags flags =
        place.width > 0 ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch;
    const auto n = static_cast<ImGuiID>(&place - places.data());
    if (n == 0) flags |= ImGuiTableColumnFlags_DefaultSort;
    if (n > 1) flags |= ImGuiTableColumnFlags_PreferSortDescending;
    ImGui::TableSetupColumn(
        title.c_str(), flags,
        place.width > 0 ? std::max(ctx.px(place.width), title_width(title.c_str())) : 1.0f, n);
  }
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const ColumnPlace& place : places) {
    ImGui::TableNextColumn();
    ImGui::PushID(place.id);
    ImGui::TableHeader(column_at(place).heading().c_str());
    record(ctx, (std::string("measures.column.") + place.id).c_str());
    tooltip(ctx, column_at(place).help);
    ImGui::PopID();
  }
}

void take_sorting(MeasureQuery& query, Places places) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || specs->SpecsCount == 0) return;
  query.column = places[specs->Specs[0].ColumnUserID].id;
  query.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  specs->SpecsDirty = false;
}

// Draws a row. Returns whether it was clicked.
bool draw_row(PanelContext& ctx, const MeasureRows& rows, const MeasureRow& row, Places places,
              bool chosen) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(row.group));
  const MeasuredRow of{rows, row};
  const bool clicked = ImGui::Selectable(column_at(places[0]).shown_text(of).c_str(), chosen,
                                         ImGuiSelectableFlags_SpanAllColumns);
  record(ctx, ("measures.row." + std::to_string(row.group + 1)).c_str());
  ImGui::PopID();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(fitted_text(row.name, ImGui::GetContentRegionAvail().x).c_str());
  for (const ColumnPlace& place : places.subspan(2)) number_cell(column_at(place).shown_text(of));
  return clicked;
}

// Draws the table. `atoms` is null while the rows do not belong to the picture; then clicks do
// nothing.
void table_of_rows(PanelContext& ctx, MeasureState& memory, const BallReferences* atoms) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable;
  const MeasureRows& rows = *memory.rows;
  const Places places = places_of(rows);
  const char* id = rows.derivatives ? "measures.changes" : "measures";
  if (!ImGui::BeginTable(id, static_cast<int>(places.size()), kFlags, {0, 0})) return;
  heading(ctx, places);
  take_sorting(memory.query, places);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.rows.size()));
  const MeasureRow* clicked = nullptr;
  while (clipper.Step()) {
    for (int n = clipper.DisplayStart; n < clipper.DisplayEnd; ++n) {
      const MeasureRow& row = rows.rows[static_cast<std::size_t>(n)];
      const bool chosen = atoms && is_chosen(memory, atoms->atom(row.first_ball));
      if (draw_row(ctx, rows, row, places, chosen)) clicked = &row;
    }
  }
  ImGui::EndTable();
  if (!clicked || !atoms) return;
  choose(memory, atoms->atom(clicked->first_ball), ImGui::GetIO().KeyCtrl);
  select_chosen(ctx, memory, *atoms);
}

void copy_when_there(PanelContext& ctx, MeasureState& memory) {
  const Derived<std::string> csv = ctx.store.want(
      measure_csv(memory.query, source_on_screen(ctx), ctx.state.result), ctx.inputs);
  if (csv.state == DerivedState::failed || csv.state == DerivedState::no_room) {
    memory.copying = false;
    ctx.state.show_error("Cannot copy the table", csv.why);
  }
  if (!csv.ready()) return;
  ImGui::SetClipboardText(csv.value->c_str());
  ctx.state.notice = "Areas and volumes copied as CSV.";
  memory.copying = false;
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
  memory.surface = surface_name(ctx.state.result->request);
}

void draw_measures(PanelContext& ctx, MeasureState& memory) {
  reset_for_molecule(memory, ctx.state.file_hash());
  ctx.state.measures_wanted = true;
  const bool whole = !ctx.inputs.complex || !ctx.inputs.complex->tetrahedra_only;
  Derived<MeasuredComplex> measured;
  Derived<MeasureRows> rows;
  if (fits(ctx) && whole) {
    measured = ctx.store.want(union_measures(), ctx.inputs);
    take_measures(ctx, memory, measured);
    memory.query.per = kPer[memory.per];
    memory.query.derivatives = memory.changes;
    rows = ctx.store.want(measure_rows(memory.query, ctx.state.result), ctx.inputs);
    if (of_the_picture(rows)) memory.rows = rows.value;
    if (memory.copying && ctx.inputs.atoms) copy_when_there(ctx, memory);
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
  table_of_rows(ctx, memory, current ? ctx.state.references.get() : nullptr);
  ImGui::PopStyleVar();
}

}  // namespace

std::unique_ptr<Panel> measures_panel() {
  return panel_of(draw_measures);
}

}  // namespace alphascope
