// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the steps of StepsState, and finds the step on show.
#include "ui/panels/explain/steps_state.hpp"

#include <algorithm>

#include "core/document/explain/steps_results.hpp"

namespace alphascope {

std::size_t StepsState::count() const {
  return shown ? shown->steps.steps.size() : 0;
}

std::size_t StepsState::last() const {
  return std::max<std::size_t>(count(), 1) - 1;
}

std::size_t StepsState::at() const {
  return count() == 0 ? step : std::min(step, last());
}

}  // namespace alphascope
