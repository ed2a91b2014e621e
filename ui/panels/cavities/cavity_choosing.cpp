// SPDX-License-Identifier: GPL-3.0-or-later
// How rows of the table are chosen. The atoms that line them become the selection.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "ui/calls.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Most cavities that can be chosen at once. With more, picture and list of residues would be
// unreadable.
constexpr std::size_t kMostChosen = 1000;

// Chooses these rows. The atoms that line them become the selection, in the same entry of the
// history.
void select_rows(PanelContext& ctx, CavityPage& page, std::vector<std::size_t> rows) {
  if (rows.size() > kMostChosen) {
    ctx.state.notice =
        "No more than " + with_separators(kMostChosen) +
        " cavities can be selected at once. The first ones of the list are selected.";
    rows.resize(kMostChosen);
  }
  const CavityTable& table = page.rows.table();
  const BallReferences& atoms = *page.rows.lines->atoms;
  std::vector<Ref> sinks;
  for (const std::size_t row : rows) sinks.emplace_back(cavity_sink(atoms, table, row));
  ctx.state.settings.selection.cavities = RefSet(std::move(sinks));
  ctx.state.settings.selection.items = lining_of(page, rows);
  if (!rows.empty()) ctx.calls.view.zoom_to_selection();
}

// Returns the rows from the anchor to `row`, in the order shown.
std::vector<std::size_t> range_to(const CavityPage& page, std::size_t row) {
  auto from = std::find(page.order.begin(), page.order.end(), page.anchor.value_or(row));
  auto to = std::find(page.order.begin(), page.order.end(), row);
  if (from == page.order.end()) from = to;  // the filter hides the anchor
  if (to < from) std::swap(from, to);
  return {from, to + 1};
}

}  // namespace

void select_cavity(PanelContext& ctx, CavityPage& page, std::size_t row, HowSelected how) {
  if (how == HowSelected::range) return select_rows(ctx, page, range_to(page, row));
  page.anchor = row;
  if (how == HowSelected::alone) return select_rows(ctx, page, {row});
  std::vector<std::size_t> rows = page.selected_rows;
  const auto at = std::lower_bound(rows.begin(), rows.end(), row);
  if (at != rows.end() && *at == row) {
    rows.erase(at);
  } else {
    rows.insert(at, row);
  }
  select_rows(ctx, page, rows);
}

void select_all_cavities(PanelContext& ctx, CavityPage& page) {
  select_rows(ctx, page, page.order);
}

void clear_cavity_selection(PanelContext& ctx) {
  ctx.state.settings.selection.clear();
}

}  // namespace alphascope
