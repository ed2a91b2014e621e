// SPDX-License-Identifier: GPL-3.0-or-later
// Makes colours anew only if the molecule, the paint or, where it matters, the complex has changed.
#include "ui/scene/picture/painting.hpp"

namespace alphascope {

std::shared_ptr<const Painting> make_painting(const PaintTask& task,
                                              std::shared_ptr<const Painting> earlier,
                                              const RunContext& context) {
  const SchemeInfo& scheme = scheme_info(task.paint.by);
  const std::shared_ptr<const EngineAnswer> answer = scheme.of_complex ? task.answer : nullptr;
  if (earlier && earlier->paint == task.paint && earlier->molecule == task.molecule &&
      earlier->answer == answer) {
    return earlier;
  }
  auto painting = std::make_shared<Painting>();
  painting->paint = task.paint;
  painting->molecule = task.molecule;
  painting->answer = answer;
  if (answer && is_exposure(task.paint.by) && !answer->complex.tetrahedra_only) {
    const bool known = earlier && earlier->measures && earlier->answer == answer;
    painting->measures = known ? earlier->measures : answer->measures;
    if (!painting->measures) {
      painting->measures = std::make_shared<const MeasuredUnion>(
          measure_on_calling_threads(*answer->balls, answer->complex, context));
    }
  }
  context.cancel.throw_if_cancelled();
  painting->balls = paint_balls({*task.molecule->molecule, task.molecule->prepared->atom_of_ball,
                                 answer ? &answer->complex : nullptr,
                                 painting->measures ? &painting->measures->measures : nullptr,
                                 answer ? answer->balls.get() : nullptr},
                                task.paint);
  return painting;
}

}  // namespace alphascope
