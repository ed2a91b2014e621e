// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a step, a count of a step, and the ball after which a dual edge no longer changes, in the
// steps of one ball.
#include "core/explain/ball_steps.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace alphascope {

const StepCount& Step::count(std::string_view id) const {
  const auto at = std::find_if(counts.begin(), counts.end(),
                               [&](const StepCount& count) { return count.id == id; });
  if (at == counts.end()) throw std::out_of_range("a step has no count " + std::string(id));
  return *at;
}

std::size_t StepDualEdge::settled_after() const {
  std::size_t settled = cuts.size();
  while (settled > 0 && (cuts[settled - 1].kind == CutKind::too_far ||
                         cuts[settled - 1].kind == CutKind::nothing)) {
    --settled;
  }
  return settled;
}

const Step* BallSteps::find(StepKind kind) const {
  const auto at =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.kind == kind; });
  return at == steps.end() ? nullptr : &*at;
}

}  // namespace alphascope
