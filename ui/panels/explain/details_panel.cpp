// SPDX-License-Identifier: GPL-3.0-or-later
// The page “Details”: facts on the selected atom or simplex, a list of the simplices around it, and
// measured distances and angles.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/document/explain/explanation_results.hpp"
#include "core/document/explain/simplex_details.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/atom_address.hpp"
#include "ui/panels/explain/details_parts.hpp"
#include "ui/panels/explain/details_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

// Returns the selected atom. An atom beside the body has no ball, so only the molecule knows it.
std::optional<std::size_t> one_atom(const ViewState& s) {
  const auto& items = s.settings.selection.items.items();
  const AtomRef* const ref = items.size() == 1 ? std::get_if<AtomRef>(&items[0]) : nullptr;
  return ref ? find_atom(s.references->molecule(), {ref->atom, ref->copy}) : std::nullopt;
}

// Returns the latest answer for these balls, also while a newer one is made.
const SimplexDetails* details_of(PanelContext& ctx, DetailsState& memory, const Balls& balls) {
  const auto found = ctx.store.want(simplex_details(balls), ctx.inputs);
  if (found.ready()) {
    memory.shown = found.value;
    memory.atoms = ctx.inputs.atoms;
  }
  const bool fits =
      memory.shown && memory.shown->balls == balls && memory.atoms == ctx.inputs.atoms;
  return fits ? memory.shown.get() : nullptr;
}

void draw_details(PanelContext& ctx, DetailsState& memory, float facts_width) {
  ViewState& s = ctx.state;
  const bool known = ctx.inputs.complex && ctx.inputs.atoms;
  const SelectedSimplex asked =
      known ? selected_simplex(s.settings.selection.items, *ctx.inputs.atoms) : SelectedSimplex{};
  const std::optional<std::size_t> atom = one_atom(s);
  const SimplexDetails* const details =
      asked.balls.empty() ? nullptr : details_of(ctx, memory, asked.balls);
  ImGui::BeginChild("facts", {facts_width, 0}, false);
  if (atom) {
    strong_text(ctx, atom_address(s.references->molecule(), *atom));
    draw_atom_facts(ctx, *s.references, *atom);
  } else if (!asked.balls.empty()) {
    strong_text(ctx, std::string(simplex_kind_name(asked.balls.size())) + " of " +
                         std::to_string(asked.balls.size()) + " atoms");
  } else {
    muted_wrapped(ctx, asked.why_not.empty() ? "Select an atom or a simplex." : asked.why_not);
    record(ctx, "details.nothing");
  }
  if (details) draw_simplex_facts(ctx, *details);
  ImGui::EndChild();
  ImGui::SameLine(0, ctx.px(12));
  ImGui::BeginChild("around", {facts_width, 0}, false);
  if (details) draw_simplices_around(ctx, *ctx.inputs.atoms, *details);
  ImGui::EndChild();
}

void draw_details(PanelContext& ctx, DetailsState& memory) {
  if (!ctx.state.references) {
    return muted_wrapped(ctx, "Open a molecule: its selected atoms are described here.");
  }
  ImGui::NewLine();
  const float gap = ctx.px(12);
  const float width = ImGui::GetContentRegionAvail().x;
  draw_details(ctx, memory, std::floor(width * 0.27f));
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("measured", {0, 0}, false);
  draw_measured_list(ctx);
  ImGui::EndChild();
}

}  // namespace

std::unique_ptr<Panel> details_panel() {
  return panel_of(draw_details);
}

}  // namespace alphascope
