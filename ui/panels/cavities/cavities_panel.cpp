// SPDX-License-Identifier: GPL-3.0-or-later
// The page of cavities: totals, differences from CASTp, filters, and the table of voids and pockets
// with the chosen ones beside it.
#include <algorithm>
#include <string>
#include <utility>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/commands/number_input.hpp"
#include "core/document/store/store.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/text/grouped_number.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/number_field.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr NumberRule kLeastVolumeRule{"The least volume", 0, 1e9, "Å³"};
// Pixels at scale 1: the width of the pane on chosen cavities, and the least height of both. Where
// there is less room, the page scrolls.
constexpr float kPaneWidth = 230, kLeastHeight = 96;
constexpr double kStaleSeconds = 0.3;  // after it, rows of an earlier picture turn grey

// --- lines above the table

void totals_line(PanelContext& ctx, const CavityTable& table) {
  const auto kind_text = [&](bool voids, std::size_t number, const char* one) {
    return with_separators(static_cast<long long>(number)) + " " + one + (number == 1 ? "" : "s") +
           " " + measure_text(table.volume_sa_angstrom3(voids)) + " Å³";
  };
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, kind_text(true, table.voids, "void"));
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, kind_text(false, table.pockets, "pocket"));
  ImGui::SameLine(0, ctx.px(14));
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, counted(table.mouths, "mouth", "mouths"));
  record(ctx, "cavities.totals");
}

// Draws the filter and the buttons of the table, in as many lines as they need.
void filter_line(PanelContext& ctx, CavityPage& page, bool current) {
  CavityFilter& filter = page.filter;
  const float field = ctx.px(56), gap = ctx.px(4), wide = ctx.px(14);
  choice(ctx, "cavities.kind", {"all", "voids", "pockets"}, filter.kind, ctx.px(180));
  same_line_where_it_fits(
      ImGui::CalcTextSize("at least").x + ctx.px(6) + field + gap + ImGui::CalcTextSize("Å³").x,
      wide);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("at least");
  ImGui::SameLine(0, ctx.px(6));
  ImGui::SetNextItemWidth(field);
  number_field(ctx, "cavities.least", filter.least_volume_angstrom3, kLeastVolumeRule);
  tooltip(ctx,
          "Hides cavities with a smaller SA volume. Volumes below 1 Å³ are within the error of "
          "coordinates and radii. 0 shows all.");
  ImGui::SameLine(0, gap);
  ImGui::TextUnformatted("Å³");
  same_line_where_it_fits(button_width("Select all"), wide);
  if (button(ctx, "cavities.all", "Select all")) select_all_cavities(ctx, page);
  tooltip(
      ctx,
      "Selects all listed cavities. Ctrl+click on a row adds one; Shift+click selects a range.");
  same_line_where_it_fits(button_width("None"), gap);
  ImGui::BeginDisabled(ctx.state.settings.selection.empty());
  if (button(ctx, "cavities.none", "None")) clear_cavity_selection(ctx);
  ImGui::EndDisabled();
  same_line_where_it_fits(button_width("Draw"), wide);
  cavity_parts_button(ctx, page);
  same_line_where_it_fits(button_width("Columns"), gap);
  cavity_columns_button(ctx, page);
  same_line_where_it_fits(button_width("Save…"), gap);
  cavity_save_button(ctx, page, current);
  const auto number = [](std::size_t n) { return with_separators(static_cast<long long>(n)); };
  const bool all = page.order.size() == page.rows.size();
  const std::string text =
      (all ? "all " : number(page.order.size()) + " of ") + number(page.rows.size()) + " shown";
  same_line_where_it_fits(ImGui::CalcTextSize(text.c_str()).x, wide);
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(text, ImGui::GetContentRegionAvail().x));
  record(ctx, "cavities.shown");
}

// --- notes that answer likely questions

// Says why the table is empty.
std::string empty_text(const CavityPage& page) {
  if (page.rows.table().ground->triangulation->dimension < 3) {
    return "All centres lie in one plane or on one line: a flat set has no cavities.";
  }
  if (page.rows.size() > 0) {
    return "No cavity passes the filter: lower the least volume, or show all kinds.";
  }
  return "There is no void or pocket at this alpha and solvent radius. Grooves, and pores that "
         "widen outwards, do not count. The page Channels measures pores.";
}

// Says why there is no table yet.
std::string waiting_text(const PanelContext& ctx, const Derived<CavityLines>& table) {
  if (!ctx.state.has_molecule()) return "Open a molecule: its cavities appear here.";
  if (table.state == DerivedState::no_room || table.state == DerivedState::failed) {
    return "There is no table of cavities. " + table.why;
  }
  return "The triangulation is still being computed. Cavities appear here afterwards.";
}

// Says that no rows will come, and offers to find them again.
void cancelled_line(PanelContext& ctx, const CavityPage& page, const Derived<CavityLines>& table) {
  if (table.state != DerivedState::cancelled) return;
  const std::string rows =
      page.rows.lines ? " The rows are of another alpha or solvent radius." : "";
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "Finding the cavities was cancelled." + rows);
  record(ctx, "cavities.cancelled");
  constexpr const char* kAgain = "Find cavities";
  same_line_where_it_fits(button_width(kAgain), ctx.px(8));
  if (button(ctx, "cavities.again", kAgain)) {
    ctx.store.retry_whole(cavity_lines(page.rows.lines));
  }
}

// Draws the table, and the chosen cavities at its right.
void body(PanelContext& ctx, CavityPage& page, bool current) {
  if (page.rows.size() == 0) {
    muted_wrapped(ctx, empty_text(page));
    record(ctx, "cavities.empty");
    return;
  }
  const float gap = ctx.px(12);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float height = std::max(room.y, ctx.px(kLeastHeight));
  draw_cavity_table(ctx, page, room.x - ctx.px(kPaneWidth) - gap, height, current);
  ImGui::SameLine(0, gap);
  draw_selected_cavities(ctx, page, height);
}

// Whether to draw the rows grey, because they belong to another alpha than the picture. For
// kStaleSeconds they are not, so that they do not flicker.
bool is_grey(CavityPage& page, bool current) {
  const double now = ImGui::GetTime();
  if (current) {
    page.stale_since_seconds = -1;
  } else if (page.stale_since_seconds < 0) {
    page.stale_since_seconds = now;
  }
  return !current && now - page.stale_since_seconds > kStaleSeconds;
}

// Chooses the row that a command asked for before there was a table.
void select_wanted_row(PanelContext& ctx, CavityPage& page) {
  const auto row = std::exchange(ctx.state.cavities.wanted_row, std::nullopt);
  if (!row) return;
  const std::size_t rows = page.rows.table().size();
  if (*row < rows) return select_cavity(ctx, page, *row, HowSelected::alone);
  ctx.state.refuse_late("There is no cavity " + with_separators(static_cast<long long>(*row) + 1) +
                        "; the last is " + with_separators(static_cast<long long>(rows)) + ".");
}

void draw_cavities(PanelContext& ctx) {
  CavityState& memory = ctx.state.cavities;
  const FollowedCavities followed = follow_cavities(ctx);
  CavityPage& page = *memory.page;
  const bool current = followed.current;
  follow_column_results(ctx, page, current);
  if (current) select_wanted_row(ctx, page);
  if (!current) cancelled_line(ctx, page, followed.wanted);
  if (!page.rows.lines) {
    if (followed.wanted.state == DerivedState::cancelled) return;
    muted_wrapped(ctx, waiting_text(ctx, followed.wanted));
    record(ctx, "cavities.waiting");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, is_grey(page, current) ? 0.55f : 1.0f);
  follow_cavity_order(page);
  totals_line(ctx, page.rows.table());
  castp_line(ctx, *page.rows.lines->atoms);
  giant_network_line(ctx, page);
  networks_line(ctx, page, current);
  filter_line(ctx, page, current);
  body(ctx, page, current);
  ImGui::PopStyleVar();
  draw_layers_of_cavities(ctx, page, current);
}

}  // namespace

std::unique_ptr<Panel> cavities_panel() {
  return panel_of(draw_cavities);
}

}  // namespace alphascope
