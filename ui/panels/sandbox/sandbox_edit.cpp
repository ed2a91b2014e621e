// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a sandbox of the balls on screen, and selects, removes and rounds in it.
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/store/answer.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace alphascope {

std::string why_not_editable(const ViewState& state) {
  if (state.settings.open.sandbox) return {};
  if (!state.result || !state.result->prepared) {
    return "There are no balls yet. Open a molecule or a preset first.";
  }
  return why_no_sandbox(state.result->prepared->balls->size());
}

void start_sandbox(ViewState& state) {
  if (state.settings.open.sandbox || !why_not_editable(state).empty()) return;
  state.settings.open.sandbox = sandbox_of(*state.result->prepared->balls);
  state.settings.selection.clear();  // it holds atoms of the file, whose numbers differ
}

std::vector<BallIndex> selected_balls(const ViewState& state) {
  std::vector<BallIndex> balls;
  if (!state.settings.open.sandbox) return balls;
  const auto add = [&](const AtomRef& atom) {
    if (atom.atom < state.settings.open.sandbox->balls.size()) balls.push_back(atom.atom);
  };
  for (const Ref& ref : state.settings.selection.items.items()) {
    if (const auto* atom = std::get_if<AtomRef>(&ref)) {
      add(*atom);
    } else {
      for (const AtomRef& corner : std::get<SimplexRef>(ref)) add(corner);
    }
  }
  std::sort(balls.begin(), balls.end());
  balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
  return balls;
}

void select_ball(ViewState& state, std::size_t ball, bool more) {
  const Ref ref = AtomRef{static_cast<std::uint32_t>(ball), 0};
  state.settings.selection.cavities = {};
  state.settings.selection.items =
      more ? state.settings.selection.items.toggled(ref) : RefSet({ref});
}

void remove_selected_balls(ViewState& state) {
  const std::vector<BallIndex> balls = selected_balls(state);
  for (auto ball = balls.rbegin(); ball != balls.rend(); ++ball) {
    remove_ball(*state.settings.open.sandbox, *ball);
  }
  state.settings.selection.clear();  // balls behind the removed ones have other numbers now
}

double snapped(double angstrom, double step) {
  if (!(step > 0)) return angstrom;
  const double value = std::round(angstrom / step) * step;
  return value == 0 ? 0 : value;
}

bool shows_flat_drawing(const ViewState& state) {
  return state.sandbox.drawing && state.settings.open.sandbox &&
         state.settings.open.sandbox->flat && state.has_molecule();
}

}  // namespace alphascope
