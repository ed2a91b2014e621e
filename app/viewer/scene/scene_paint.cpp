// Colours of balls and simplices. Colours that depend on the complex are made with its drawing, so
// that no picture mixes two alphas. After a change of paint alone, a worker makes the balls'
// colours. The last colours and their legend stay until then.
#include <utility>

#include "app/viewer/scene/scene_controller.hpp"
#include "core/document/measures/measure_results.hpp"
#include "ui/scene/display_style.hpp"

namespace alphascope {

// Runs on the worker's thread. Returns `earlier`, which may be null, if its colours are the same.
std::shared_ptr<const SceneController::Painting> SceneController::make_painting(
    const PaintTask& task, std::shared_ptr<const Painting> earlier, const RunContext& context) {
  const SchemeInfo& scheme = scheme_info(task.paint.by);
  const std::shared_ptr<const Answer> answer = scheme.of_complex ? task.answer : nullptr;
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
          measure_here(*answer->balls, answer->complex, context));
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

void SceneController::submit_painting() {
  if (!drawn_molecule_ || draws_nothing()) return;
  const PaintTask task{drawn_molecule_, drawn_answer_, display_.ball_paint};
  paint_worker_.submit(
      [this, task, earlier = ball_painting_](const RunContext& context) -> Worker::Delivery {
        return [this, task, painting = make_painting(task, earlier, context)] {
          if (task.molecule != drawn_molecule_ || task.answer != drawn_answer_) return;
          ball_painting_ = painting;
          show_ball_colours();
        };
      });
}

void SceneController::show_ball_colours() {
  if (!drawn_molecule_ || !ball_painting_) return;
  scene_.set_ball_colours(painted(ball_painting_->balls.colours, drawn_looks_.get()));
  dirty_ = true;
}

std::optional<PaintKey> SceneController::ball_key() const {
  if (!display_.balls || !ball_painting_) return std::nullopt;
  return ball_painting_->balls.key;
}

std::optional<PaintKey> SceneController::simplex_key() const {
  if (!drawn_mesh_) return std::nullopt;
  return mesh_key(*drawn_mesh_, drawn_options_,
                  simplex_painting_ ? simplex_painting_->balls.key : std::nullopt);
}

void SceneController::describe_colours(ViewportInfo& viewport) const {
  const std::optional<PaintKey> balls = ball_key(), simplices = simplex_key();
  const auto range = [](const std::optional<PaintKey>& key) {
    return key && key->scale ? std::optional(key->scale->range) : std::nullopt;
  };
  viewport.legends = legends_of(balls, simplices);
  viewport.ball_range = range(balls);
  viewport.simplex_range = range(simplices);
}

std::string SceneController::not_drawn() const {
  std::string text = not_drawn_;
  const auto add = [&text](const std::string& sentence) {
    if (sentence.empty() || text.find(sentence) != std::string::npos) return;
    text += (text.empty() ? "" : " ") + sentence;
  };
  if (draws_nothing()) return text;
  if (display_.balls && ball_painting_) add(ball_painting_->balls.lacks);
  if (drawn_mesh_ && !drawn_mesh_->empty() && simplex_painting_)
    add(simplex_painting_->balls.lacks);
  return text;
}

}  // namespace alphascope
