// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that are saved from the window, and the frames of recordings.
#include <stdexcept>
#include <utility>

#include "app/session/engine_cache.hpp"
#include "app/session/result_header.hpp"
#include "app/viewer/scene/scene_controller.hpp"
#include "ui/scene/picture/picture_maker.hpp"

namespace alphascope {

// Lines keep the share of the picture that they have in the window.
float SceneController::line_scale_of(int height) const {
  const int shown = shown_.canvas().height();
  const float factor = shown > 0 ? static_cast<float>(height) / static_cast<float>(shown) : 1.0f;
  return controls_.line_scale * factor;
}

PictureToSave SceneController::picture(const ScreenshotRequest& request) const {
  if (drawn().draws_nothing()) throw std::runtime_error(drawn().not_drawn);
  if (!drawn().molecule) {
    throw std::runtime_error("The picture is still being drawn. Save it when it is ready.");
  }
  PictureFrame frame;
  frame.layers = shown_.layers().for_saved_pictures();
  require_room(
      request.options.width, request.options.height, free_memory_(),
      second_scene_bytes(drawn().molecule->geometry->centres.size(), drawn().parts.mesh.get()) +
          layer_bytes(layer_points(frame.layers)) + shown_.objects().bytes());
  frame.style = shown_.canvas().style();
  frame.style.line_scale = line_scale_of(request.options.height);
  frame.viewpoint = shown_.canvas().scene().viewpoint_of_pictures();
  frame.options = request.options;
  frame.beside_body = shown_.beside_body().mesh;
  frame.objects = shown_.objects().pictured();
  frame.layer_objects = shown_.layers().objects_for_saved_pictures();
  frame.texts = picture_texts(drawn().header());
  frame.not_drawn = drawn().not_drawn;
  PictureToSave picture{
      picture_of(*drawn().molecule, drawn().answer.get(), drawn().parts, std::move(frame)),
      request.path};
  picture.not_drawn.clear();  // the window says so already
  return picture;
}

FrameSource SceneController::frames(const RecordRequest& request) const {
  PictureToSave shown = picture({request.path, request.options});
  if (request.recording.kind == RecordingKind::turntable) {
    const auto shared = std::make_shared<const Picture>(std::move(shown));
    return {[shared](std::optional<double>, const RunContext&) { return *shared; }};
  }
  if (!drawn().answer) throw std::runtime_error("There is no complex yet.");
  // Later changes in the window do not reach this copy. Drawings of pages belong to one alpha, so
  // SweepRecorder records sweeps that have them.
  const auto maker =
      std::make_shared<PictureMaker>(*drawn().molecule,
                                     PictureSettings{controls_.display,
                                                     controls_.theme,
                                                     line_scale_of(request.options.height),
                                                     controls_.appearance,
                                                     controls_.objects,
                                                     {drawn().parts.clip, false, true, {}},
                                                     cameras().place_of_pictures(),
                                                     request.options,
                                                     {},
                                                     free_memory_},
                                     make_mesh_);
  const auto engines = std::make_shared<EngineCache>(&make_engine);
  return {[maker, engines, opened = drawn().molecule->opened, wanted = drawn().answer->request](
              std::optional<double> alpha, const RunContext& context) {
    Request request_of_frame = wanted;
    request_of_frame.alpha_angstrom2 = alpha.value();
    const auto answer = engines->compute_shared(opened->prepared->balls, request_of_frame, context);
    return maker->make(answer, picture_texts(header_of(*opened, *answer)), context);
  }};
}

}  // namespace alphascope
