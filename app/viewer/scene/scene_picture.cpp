// Texts of saved pictures, and the frames of recordings.
#include <stdexcept>

#include "app/session/engine_cache.hpp"
#include "app/session/result_header.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/caption.hpp"
#include "ui/scene/display_style.hpp"

namespace alphascope {

// The data of a sweep, copied so that later changes in the window do not reach it.
struct SceneController::Sweep {
  PictureToSave picture;  // the picture at the start; each frame replaces its complex
  std::shared_ptr<const DrawnMolecule> molecule;
  std::shared_ptr<const BallAppearance> looks;
  Request request;
  DisplayControls display;
  MeshOptions mesh;
  Clip clip;
  PictureOptions options;
  std::shared_ptr<const Painting> balls, simplices;  // of the last frame; null: none
  EngineCache engines{&make_engine};
};

ComplexHeader SceneController::header_of(const OpenedMolecule& opened, const EngineAnswer& answer) {
  return result_header("alphascope",
                       provenance(*opened.molecule, opened.options.balls, opened.prepared->report),
                       opened.molecule->notes, answer);
}

std::vector<std::string> SceneController::caption(CaptionParts parts) const {
  if (!drawn_answer_) return {};
  return caption_words(*drawn_answer_, *drawn_molecule_->molecule,
                       drawn_molecule_->prepared->report.radii_name, parts);
}

FrameSource SceneController::frames(const RecordRequest& request) const {
  PictureToSave shown = picture({request.path, request.options});
  if (request.recording.kind == RecordingKind::turntable) {
    const auto shared = std::make_shared<const Picture>(std::move(shown));
    return {[shared](std::optional<double>, const RunContext&) { return *shared; }};
  }
  if (!drawn_answer_) throw std::runtime_error("There is no complex yet.");
  const auto sweep = std::make_shared<Sweep>();
  sweep->picture = std::move(shown);
  sweep->molecule = drawn_molecule_;
  sweep->looks = drawn_looks_;
  sweep->request = drawn_answer_->request;
  sweep->display = display_;
  sweep->mesh = mesh_options();
  sweep->clip = drawn_caps_.clip;
  sweep->options = request.options;
  return {[this, sweep](std::optional<double> alpha, const RunContext& context) {
    return sweep_picture(*sweep, alpha.value(), context);
  }};
}

// Runs on the recording's thread. Drawings of pages belong to one alpha, so SweepRecorder records
// sweeps that have them.
Picture SceneController::sweep_picture(Sweep& sweep, double alpha,
                                       const RunContext& context) const {
  const DrawnMolecule& m = *sweep.molecule;
  const BallAppearance* const looks = sweep.looks.get();
  Request request = sweep.request;
  request.alpha_angstrom2 = alpha;
  const auto answer = std::make_shared<Answer>();
  static_cast<EngineAnswer&>(*answer) = sweep.engines.compute(m.prepared->balls, request, context);
  answer->molecule = m.molecule;
  answer->prepared = m.prepared;
  sweep.engines.share(answer);
  const DrawingPlan plan = plan_drawing({0, &answer->complex, nullptr, sweep.mesh}, free_memory_());
  Picture picture = sweep.picture;
  picture.not_drawn = not_drawn_text(plan);
  picture.layers.clear();
  picture.differences = nullptr;
  // As in make_drawing(), since colours may depend on the complex.
  sweep.balls =
      make_painting({sweep.molecule, answer, sweep.display.ball_paint}, sweep.balls, context);
  picture.colours = painted(sweep.balls->balls.colours, looks);
  if (plan.mesh.colouring == ComplexColouring::balls) {
    sweep.simplices = make_painting({sweep.molecule, answer, sweep.display.complex_paint},
                                    sweep.simplices, context);
  }
  const auto colours = std::make_shared<const std::vector<Rgb8>>(
      painted((sweep.simplices ? sweep.simplices : sweep.balls)->balls.colours, looks));
  if (sweep.display.grown_balls) {
    picture.radii = radii_of(m, ball_style(sweep.display, &request), looks);
  }
  const auto mesh = std::make_shared<const ComplexMesh>(
      make_mesh(m, *colours, answer->complex, plan.mesh, looks, context.cancel));
  picture.mesh = mesh;
  picture.caps = make_caps({sweep.molecule, answer, mesh, plan.mesh, colours, sweep.looks},
                           sweep.clip, context.cancel)
                     .mesh;
  if (sweep.options.legend) {
    picture.picture.legends = legends_of(
        sweep.display.balls ? sweep.balls->balls.key : std::nullopt,
        mesh_key(*mesh, plan.mesh, sweep.simplices ? sweep.simplices->balls.key : std::nullopt));
  }
  picture.picture.caption =
      caption_words(*answer, *m.molecule, m.prepared->report.radii_name, sweep.options.caption);
  picture.texts = picture_texts(header_of(*m.opened, *answer));
  if (looks != nullptr) note_hidden_atoms(picture.texts, looks->hidden_balls);
  if (!picture.not_drawn.empty()) picture.texts.emplace_back("Warning", picture.not_drawn);
  return picture;
}

}  // namespace alphascope
