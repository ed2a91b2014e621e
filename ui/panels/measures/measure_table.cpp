// SPDX-License-Identifier: GPL-3.0-or-later
// The table of areas and volumes: its columns, its order, and the rows that are chosen.
#include <imgui.h>
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/measures/measure_columns.hpp"
#include "core/document/measures/measure_rows.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/tables/column.hpp"
#include "ui/calls.hpp"
#include "ui/panels/measures/measure_parts.hpp"
#include "ui/panels/measures/measure_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

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
    ctx.state.notice =
        "Only the first " + with_separators(Selection::kMostItems) + " atoms are selected.";
  }
  ctx.state.settings.selection.items = RefSet(std::move(refs));
  if (!memory.chosen.empty()) ctx.calls.view.zoom_to_selection();
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

}  // namespace

void draw_measure_table(PanelContext& ctx, MeasureState& memory, const BallReferences* atoms) {
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

}  // namespace alphascope
