// SPDX-License-Identifier: GPL-3.0-or-later
// Notes that a user needs to understand the picture of a step.
#include <string>
#include <vector>

#include "core/document/explain/steps_results.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/panels/explain/steps_parts.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

std::vector<std::string> steps_notes(const PanelContext& ctx) {
  const StepsState& memory = ctx.state.steps;
  std::vector<std::string> notes;
  if (shows_flat_drawing(ctx.state)) {
    notes.push_back(
        "The flat drawing does not show steps. Switch it off, on the page Sandbox, to see them.");
  }
  if (ctx.state.settings.appearance.hidden.contains(
          ctx.inputs.atoms->atom(memory.shown->steps.ball))) {
    notes.push_back("This atom is hidden in the picture, but the steps use it.");
  }
  return notes;
}

}  // namespace alphascope
