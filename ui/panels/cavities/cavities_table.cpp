// SPDX-License-Identifier: GPL-3.0-or-later
// The table of cavities. The user chooses its columns, and only rows in sight are drawn.
#include <algorithm>
#include <string>
#include <string_view>

#include "core/chart/colour_map.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/key.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

int column_count() {
  return static_cast<int>(cavity_page_columns().size());
}

// Returns the first width of a column, pixels.
float column_width(const PanelContext& ctx, const CavityPageColumn& placed) {
  return std::max(ctx.px(placed.width), title_width(placed.column->heading().c_str()));
}

void set_up_columns(PanelContext& ctx) {
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const CavityPageColumn& placed : cavity_page_columns()) {
    ImGuiTableColumnFlags flags = ImGuiTableColumnFlags_WidthFixed;
    if (placed.is("id")) {
      flags |= ImGuiTableColumnFlags_DefaultSort | ImGuiTableColumnFlags_NoHide;
    } else if (placed.is("name") || placed.is("holds")) {
      flags = ImGuiTableColumnFlags_WidthStretch;
    } else if (!placed.is("kind")) {
      flags |= ImGuiTableColumnFlags_PreferSortDescending;
    }
    if (!placed.shown_first) flags |= ImGuiTableColumnFlags_DefaultHide;
    ImGui::TableSetupColumn(placed.column->heading().c_str(), flags, column_width(ctx, placed));
  }
}

// Returns the explanation of a column. The page has marks that files lack, so it explains them too.
std::string help_text(const Column<CavityRow>& column) {
  std::string text = column.help;
  if (std::string_view(column.id) == "kind") {
    text +=
        " ↔: it lies between separate bodies, or exactly two chains line it, each with at least a "
        "fifth of the residues. ↕: it split off or merged in the last movement of a slider.";
  }
  return text;
}

void draw_headers(PanelContext& ctx) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int n = 0; n < column_count(); ++n) {
    if (!ImGui::TableSetColumnIndex(n)) continue;
    const Column<CavityRow>& column = *cavity_page_columns()[static_cast<std::size_t>(n)].column;
    ImGui::TableHeader(column.heading().c_str());
    record(ctx, (std::string("cavities.column.") + column.id).c_str());
    tooltip(ctx, help_text(column).c_str());
  }
}

// Carries the choice of columns from the page to ImGui's table and back. The table has a menu of
// its own, which a right click on a title opens.
void follow_columns(CavityPage& page) {
  const bool tell = std::exchange(page.columns_changed, false);
  for (int n = 0; n < column_count(); ++n) {
    const auto at = static_cast<std::size_t>(n);
    if (tell) {
      ImGui::TableSetColumnEnabled(n, page.columns[at]);
    } else {
      page.columns[at] = (ImGui::TableGetColumnFlags(n) & ImGuiTableColumnFlags_IsEnabled) != 0;
    }
  }
}

void take_sorting(CavityFilter& filter) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || !specs->SpecsDirty || specs->SpecsCount == 0) return;
  filter.sort_column = specs->Specs[0].ColumnIndex;
  filter.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  specs->SpecsDirty = false;
}

}  // namespace

void follow_cavity_order(CavityPage& page) {
  const bool old = std::exchange(page.rows_are_old, false);
  if (!old && page.ordered_by == page.filter) return;
  page.ordered_by = page.filter;
  page.order = ordered_rows(page.rows, page.filter);
}

namespace {

// Draws a mark in the colour of the cavity's surface before the word. Text in that colour would be
// hard to read.
void kind_cell(PanelContext& ctx, const CavityPage& page, std::size_t row) {
  const CavityLine& line = page.rows.lines->of[row];
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side = ctx.px(9), top = corner.y + (ImGui::GetTextLineHeight() - side) / 2;
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + side, top + side},
                                            to_u32(cavity_colour(page, row)));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side + ctx.px(6));
  const std::string between = between_text(line, {}), change = change_text(page, row);
  std::string text = kind_word(line);
  if (!between.empty()) text += " ↔";
  if (!change.empty()) text += " ↕";
  ImGui::TextUnformatted(text.c_str());
  std::string why = line.is_network ? mouths_text(line.mouths) : part_text(line);
  for (const std::string& more : {between, change}) {
    why += (why.empty() || more.empty() ? "" : "\n") + more;
  }
  if (!why.empty()) tooltip(ctx, why.c_str());
}

// Draws a text, cut if it does not fit. The tooltip then shows all of it.
void text_cell(PanelContext& ctx, const std::string& text) {
  const std::string fitted = fitted_text(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(fitted.c_str());
  if (fitted != text) tooltip(ctx, text.c_str());
}

// Draws a row. Returns whether it was clicked.
bool draw_row(PanelContext& ctx, CavityPage& page, std::size_t row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(row));
  const std::string number = std::to_string(row + 1);
  const bool marked = ctx.state.cavities.under_mouse == row ||
                      std::binary_search(page.selected_rows.begin(), page.selected_rows.end(), row);
  const bool clicked = ImGui::Selectable(
      number.c_str(), marked,
      ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap);
  if (ImGui::IsItemHovered()) page.hovered = row;
  record(ctx, ("cavities.row." + number).c_str());
  ImGui::PopID();
  for (int n = 1; n < column_count(); ++n) {
    if (!ImGui::TableSetColumnIndex(n)) continue;
    const CavityPageColumn& placed = cavity_page_columns()[static_cast<std::size_t>(n)];
    if (placed.is("kind")) {
      kind_cell(ctx, page, row);
    } else if (placed.is("name") || placed.is("holds")) {
      text_cell(ctx, placed.column->shown_text({page.rows, row}));
    } else {
      right_text(placed.column->shown_text({page.rows, row}));
    }
  }
  return clicked;
}

HowSelected how_selected() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyShift) return HowSelected::range;
  return io.KeyCtrl ? HowSelected::toggled : HowSelected::alone;
}

// A cavity under the mouse in the picture comes into sight, once.
void scroll_to_pointed(const PanelContext& ctx, CavityPage& page) {
  const auto row = ctx.state.cavities.under_mouse;
  if (std::exchange(page.scrolled, row) == row || !row) return;
  const auto at = std::find(page.order.begin(), page.order.end(), *row);
  if (at == page.order.end()) return;  // the filter hides it
  const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float line = static_cast<float>(at - page.order.begin()) * height;
  const float seen = ImGui::GetWindowHeight() - 2 * height;  // without titles and scroll bar
  const bool in_sight = line >= ImGui::GetScrollY() && line + height <= ImGui::GetScrollY() + seen;
  if (!in_sight) ImGui::SetScrollY(std::max(0.0F, line - seen / 2));
}

// Returns the width of the columns on show, at their first widths.
float least_width(PanelContext& ctx, const CavityPage& page) {
  float width = 0;
  for (std::size_t n = 0; n < page.columns.size(); ++n) {
    if (!page.columns[n]) continue;
    width += column_width(ctx, cavity_page_columns()[n]) + 2 * ImGui::GetStyle().CellPadding.x;
  }
  return width;
}

}  // namespace

void cavity_columns_button(PanelContext& ctx, CavityPage& page) {
  if (button(ctx, "cavities.columns", "Columns")) ImGui::OpenPopup("cavities.columns");
  tooltip(ctx,
          "Chooses the columns of the table. A right click on a column title opens the same list.");
  if (!ImGui::BeginPopup("cavities.columns")) return;
  close_on_escape();
  for (std::size_t n = 1; n < page.columns.size(); ++n) {
    const Column<CavityRow>& column = *cavity_page_columns()[n].column;
    bool shown = page.columns[n];
    const std::string name = std::string("cavities.columns.") + column.id;
    if (checkbox(ctx, name.c_str(), column.heading().c_str(), shown)) {
      page.columns[n] = shown;
      page.columns_changed = true;
    }
    tooltip(ctx, help_text(column).c_str());
  }
  ImGui::EndPopup();
}

void draw_cavity_table(PanelContext& ctx, CavityPage& page, float width, float height,
                       bool current) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_ScrollX | ImGuiTableFlags_RowBg |
                                     ImGuiTableFlags_Resizable | ImGuiTableFlags_Hideable;
  const float inner = std::max(least_width(ctx, page), width - ImGui::GetStyle().ScrollbarSize);
  if (!ImGui::BeginTable("cavities", column_count(), kFlags, {width, height}, inner)) return;
  set_up_columns(ctx);
  draw_headers(ctx);
  follow_columns(page);
  take_sorting(page.filter);
  follow_cavity_order(page);
  scroll_to_pointed(ctx, page);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(page.order.size()));
  std::optional<std::size_t> clicked;
  while (clipper.Step()) {
    for (int n = clipper.DisplayStart; n < clipper.DisplayEnd; ++n) {
      const std::size_t row = page.order[static_cast<std::size_t>(n)];
      if (draw_row(ctx, page, row)) clicked = row;
    }
  }
  ImGui::EndTable();
  if (clicked && current) select_cavity(ctx, page, *clicked, how_selected());
}

}  // namespace alphascope
