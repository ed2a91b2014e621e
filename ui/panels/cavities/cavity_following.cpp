// SPDX-License-Identifier: GPL-3.0-or-later
// Follows cavities while alpha or the solvent radius moves, and finds the rows of the chosen ones.
// The page of cavities and others that show chosen cavities use it.
#include <algorithm>
#include <string>
#include <utility>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/commands/commands.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/molecule/reset_for_molecule.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

// Empties the page for another molecule. Filter, columns and drawn parts stay.
void begin_page(CavityPage& page, const std::string& molecule) {
  reset_for_molecule(page, molecule, [](const CavityPage& old) {
    CavityPage fresh;
    fresh.filter = old.filter;
    fresh.columns = old.columns;
    fresh.parts = old.parts;
    fresh.fades_rest = old.fades_rest;
    fresh.choice.key = old.choice.key;
    fresh.layers_key = old.layers_key;
    return fresh;
  });
  if (!page.columns.empty()) return;
  for (const CavityPageColumn& c : cavity_page_columns()) page.columns.push_back(c.shown_first);
}

// Notes splits and merges of cavities. They stay marked until the next movement of a slider.
void note_changes(CavityPage& page, const CavityNumbers& numbers) {
  constexpr double kMovementSeconds = 1;
  const double now = ImGui::GetTime();
  const bool next = now - std::exchange(page.changed_at_seconds, now) > kMovementSeconds;
  if (next || numbers.steps == 0) page.changes.clear();
  for (std::uint32_t c = 0; c < numbers.of.size(); ++c) {
    if (numbers.parted_from[c] != CavityMatch::kNone) {
      page.changes[numbers.of[c]].parted_from = numbers.parted_from[c];
    }
    if (numbers.merged[c] > 0) page.changes[numbers.of[c]].merged += numbers.merged[c];
  }
}

void take_lines(CavityPage& page, const std::shared_ptr<const CavityLines>& lines) {
  const bool other_balls = !page.rows.lines || page.rows.table().ground != lines->table->ground;
  const auto lives = other_balls ? nullptr : page.rows.lives;
  // If networks are split or joined, cavities are listed anew but have not changed.
  const bool listed_anew = page.rows.lines && page.rows.table().question.split_networks !=
                                                  lines->table->question.split_networks;
  page.rows = {};
  page.rows.all = lines->table;
  page.rows.atoms = lines->atoms;
  page.rows.lines = lines;
  page.rows.lives = lives;
  page.rows_are_old = true;
  page.anchor.reset();
  if (listed_anew) {
    page.changes.clear();
  } else {
    note_changes(page, *lines->numbers);
  }
}

// Returns whether the rows belong to the picture; if not, asks for new ones. New rows continue the
// cavity numbers of the rows on screen.
bool follow_lines(PanelContext& ctx, CavityPage& page, Derived<CavityLines>& wanted) {
  if (page.rows.lines && page.rows.lines->is_of(ctx.inputs)) return true;
  const bool same_body = page.rows.lines && page.body_key == ctx.inputs.body_key;
  const auto before = same_body ? page.rows.lines : nullptr;
  wanted = ctx.store.want(cavity_lines(before), ctx.inputs);
  if (!wanted.value || wanted.have.balls != wanted.wanted.balls) return false;
  // Rows whose computation began before those on screen were made do not continue their numbers.
  const std::uint64_t steps = wanted.value->numbers->steps;
  if (before ? steps != before->numbers->steps + 1 : steps != 0) return false;
  page.body_key = ctx.inputs.body_key;
  take_lines(page, wanted.value);
  return page.rows.lines->is_of(ctx.inputs);
}

std::string rows_text(const std::vector<std::size_t>& rows) {
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    text += (k == 0                ? ""
             : k + 1 < rows.size() ? ", "
                                   : " and ") +
            std::string("cavity ") + with_separators(static_cast<long long>(rows[k]) + 1);
  }
  return text;
}

// Says once in the status bar that chosen cavities have merged or parted, since another page may be
// open.
void tell_of_merging(PanelContext& ctx, const CavityPage& page, bool merged_before) {
  const bool merged = !page.merged_into.empty();
  if (merged && !merged_before) {
    ctx.state.notice = merged_text(page);
  } else if (merged_before && !merged && !page.selected_rows.empty()) {
    ctx.state.notice = "The selected cavity is separate again.";
  }
}

// The selection follows the lining atoms, unless the user has selected other items meanwhile. After
// an undo it holds the history's items. They were right at their alpha, so they stay.
void follow_lining(PanelContext& ctx, CavityPage& page) {
  RefSet lining = lining_of(page, page.selected_rows);
  RefSet& selected = ctx.state.settings.selection.items;
  if (!page.chosen.empty() && selected == page.lining && !(selected == lining)) {
    selected = lining;
    ctx.state.selection_followed = true;
  }
  page.lining = std::move(lining);
}

void find_selected_rows(PanelContext& ctx, CavityPage& page) {
  const RefSet& chosen = ctx.state.settings.selection.cavities;
  CavityPage::Choice& choice = page.choice;
  const bool same_rows = page.chosen == chosen && page.selected_in == page.rows.lines;
  if (same_rows && choice.parts == page.parts) return;
  const bool same_choice = page.chosen == chosen, merged_before = !page.merged_into.empty();
  page.chosen = chosen;
  page.selected_in = page.rows.lines;
  SelectedRows found = rows_of_cavities(*page.rows.lines, chosen);
  page.selected_rows = std::move(found.rows);
  page.merged_into = std::move(found.merged_into);
  if (same_choice) {
    tell_of_merging(ctx, page, merged_before);
    follow_lining(ctx, page);
  } else {
    page.lining = lining_of(page, page.selected_rows);
  }
  choice.parts = page.parts;
  choice.sinks.clear();
  for (const std::size_t row : page.selected_rows) {
    choice.sinks.push_back(page.rows.table().sink(row));
  }
  std::sort(choice.sinks.begin(), choice.sinks.end());
  ++choice.key;
  std::vector<std::size_t> rows = page.selected_rows;
  if (page.anchor) {
    std::stable_partition(rows.begin(), rows.end(),
                          [&](std::size_t row) { return row != *page.anchor; });
  }
  auto& sinks = ctx.state.cavities.chosen;
  sinks.clear();
  for (const std::size_t row : rows) {
    sinks.push_back(cavity_sink(*page.rows.lines->atoms, page.rows.table(), row));
  }
}

}  // namespace

void forget_cavities(CavityState& state) {
  state.chosen.clear();
  state.wanted_row.reset();
  if (state.page) begin_page(*state.page, "");
}

RefSet lining_of(const CavityPage& page, const std::vector<std::size_t>& rows) {
  const CavityTable& table = page.rows.table();
  std::vector<Ref> lining;
  for (const std::size_t row : rows) {
    for (const BallIndex ball : table.measure(row).lining) {
      if (lining.size() < Selection::kMostItems) {
        lining.emplace_back(page.rows.lines->atoms->atom(ball));
      }
    }
  }
  return RefSet(std::move(lining));
}

std::string merged_text(const CavityPage& page) {
  if (page.merged_into.empty()) return {};
  const bool one = page.chosen.size() == 1;
  return std::string(one ? "The selected cavity has" : "Selected cavities have") + " merged into " +
         rows_text(page.merged_into) + ".";
}

FollowedCavities follow_cavities(PanelContext& ctx) {
  CavityState& memory = ctx.state.cavities;
  if (!memory.page) memory.page = std::make_shared<CavityPage>();
  CavityPage& page = *memory.page;
  begin_page(page, ctx.state.file_hash());
  FollowedCavities followed;
  followed.current = follow_lines(ctx, page, followed.wanted);
  if (page.rows.lines) {
    find_selected_rows(ctx, page);
  } else {
    memory.chosen.clear();
  }
  return followed;
}

}  // namespace alphascope
