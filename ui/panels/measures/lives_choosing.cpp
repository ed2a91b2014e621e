// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the cavity of a bar, and describes the bar.
#include <string>
#include <vector>

#include "core/cavity/cavity_ground.hpp"
#include "core/complex/triangulation.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/measures/lives_parts.hpp"
#include "ui/panels/measures/lives_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::string life_text(const PanelContext& ctx, const ShownLives& memory, const KnownLives& known,
                      std::size_t bar) {
  const std::size_t row = row_of_bar(memory, *known.page, bar);
  const bool there = row != ShownLives::kNoRow;
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  return (there ? "Cavity " + std::to_string(row + 1)
                : std::string("Does not exist at this alpha")) +
         "\n" + bar_text(memory.bars.longest[bar]) + "\nDeepest point between " +
         sink_name(*ctx.inputs.atoms, sink) +
         (there ? "\nClick to select it."
                : "\nClick to select it and go to an alpha at which it exists.");
}

void choose_life(PanelContext& ctx, const ShownLives& memory, const KnownLives& known,
                 std::size_t bar) {
  const std::size_t row = row_of_bar(memory, *known.page, bar);
  if (row != ShownLives::kNoRow) return select_cavity(ctx, *known.page, row, HowSelected::alone);
  const auto& sink = known.ground->triangulation->tetrahedra[memory.bars.longest[bar].sink];
  ctx.state.settings.selection.cavities =
      RefSet(std::vector<Ref>{ctx.inputs.atoms->reference(sink)});
  ctx.state.settings.selection.items = {};
  ctx.state.go_to_alpha(alpha_within(memory.bars.longest[bar], memory.from_angstrom2));
}

}  // namespace alphascope
