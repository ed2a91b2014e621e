// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the bars of cavities anew when their results change, and finds their rows in the table.
#include <algorithm>
#include <map>
#include <memory>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/geometry/ball_set.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/measures/lives_parts.hpp"
#include "ui/panels/measures/lives_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kMostBars = 100;

// Finds the row of each bar in the table on screen.
void find_rows(ShownLives& memory, const CavityPage& page) {
  if (memory.lines == page.rows.lines) return;
  memory.lines = page.rows.lines;
  memory.rows.assign(memory.bars.longest.size(), ShownLives::kNoRow);
  std::map<std::uint32_t, std::size_t> bar_of;
  for (std::size_t k = 0; k < memory.bars.longest.size(); ++k) {
    bar_of[memory.bars.longest[k].sink] = k;
  }
  for (std::size_t row = 0; row < page.rows.size(); ++row) {
    const auto at = bar_of.find(page.rows.table().cavity(row).deepest_sink);
    if (at != bar_of.end()) memory.rows[at->second] = row;
  }
}

}  // namespace

bool follow_lives(PanelContext& ctx, ShownLives& memory, KnownLives& known,
                  const Derived<CavityLives>& lives) {
  const Derived<CavityGround> ground = ctx.store.want(cavity_ground(), ctx.inputs);
  known.ground = ground.value;
  known.current = lives.ready() && ground.ready() && ctx.inputs.atoms;
  if (!known.current) return memory.of != nullptr;
  const double from = std::min(kCurveAlphaLeastAngstrom2, ctx.inputs.alpha_angstrom2.nearest());
  if (memory.of != lives.value || memory.from_angstrom2 != from) {
    memory.bars = longest_bars(*lives.value, ground.value->balls->lattice, from, kMostBars);
    memory.of = lives.value;
    memory.from_angstrom2 = from;
    memory.lines.reset();
  }
  const bool same_balls =
      known.page->rows.lines && known.page->rows.table().ground->balls == ctx.inputs.balls;
  if (same_balls) find_rows(memory, *known.page);
  return true;
}

std::size_t row_of_bar(const ShownLives& memory, const CavityPage& page, std::size_t bar) {
  const bool same = memory.lines && memory.lines == page.rows.lines;
  return same ? memory.rows.at(bar) : ShownLives::kNoRow;
}

}  // namespace alphascope
