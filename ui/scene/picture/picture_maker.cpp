// SPDX-License-Identifier: GPL-3.0-or-later
// Makes pictures by the recipe of drawn_parts.hpp, and draws them in an EGL context into files.
#include "ui/scene/picture/picture_maker.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/document/commands/number_input.hpp"
#include "ui/scene/camera_place.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/mesh/beside_body.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/window/egl_context.hpp"

namespace alphascope {
namespace {

void begin(const RunContext& context, const char* step, double share) {
  context.cancel.throw_if_cancelled();
  context.report(step, share);
}

constexpr const char* kPreparing = "preparing the picture";

void require_size(const PictureOptions& options) {
  constexpr int kLeast = static_cast<int>(kPictureSizeRule.least),
                kMost = static_cast<int>(kPictureSizeRule.most);
  if (options.width < kLeast || options.width > kMost || options.height < kLeast ||
      options.height > kMost) {
    throw std::invalid_argument("screenshot size " + std::to_string(options.width) + "x" +
                                std::to_string(options.height) + " is out of range; use " +
                                std::to_string(kLeast) + " to " + std::to_string(kMost) +
                                " pixels each way");
  }
}

DrawingPlan plan_picture(const PictureSettings& settings, std::size_t balls,
                         const AlphaComplex& complex) {
  const PictureOptions& options = settings.options;
  require_size(options);
  std::optional<std::uint64_t> free = settings.free_memory ? settings.free_memory() : std::nullopt;
  require_room(options.width, options.height, free);
  if (free) *free -= std::min(*free, picture_bytes(options.width, options.height));
  return plan_drawing({balls, &complex, nullptr, mesh_options(settings.display, settings.theme)},
                      free);
}

}  // namespace

PictureMaker::PictureMaker(PicturedMolecule molecule, PictureSettings settings, MeshMaker make_mesh)
    : molecule_(std::make_shared<const PicturedMolecule>(std::move(molecule))),
      settings_(std::move(settings)),
      make_mesh_(std::move(make_mesh)) {}

// Makes all that the pictures share. It follows from the balls and the settings alone.
void PictureMaker::make_molecule(const RunContext& context) {
  if (std::exchange(begun_, true)) return;
  if (!molecule_->geometry) {
    PicturedMolecule made = *molecule_;
    made.geometry = std::make_shared<const BallGeometry>(*made.prepared->balls);
    molecule_ = std::make_shared<const PicturedMolecule>(std::move(made));
  }
  const PicturedMolecule& m = *molecule_;
  looks_ = make_ball_appearance(m, settings_.appearance);
  FactsOnce facts;
  const PreparedBalls beside =
      left_out_and_shown(*m.molecule, *m.prepared, settings_.appearance.hidden);
  if (!beside.left_out.empty()) {
    beside_body_ = build_beside_body(*m.geometry, *m.molecule, beside, facts.of(m, context)->bonds,
                                     settings_.display.beside, context.cancel)
                       .mesh;
  }
  objects_ = build_objects(m, facts, settings_.objects, settings_.appearance, context);
}

Picture PictureMaker::make(const std::shared_ptr<const EngineAnswer>& answer, PictureTexts texts,
                           const RunContext& context) {
  begin(context, kPreparing, 0);
  const DrawingPlan plan =
      plan_picture(settings_, molecule_->prepared->balls->size(), answer->complex);
  PictureFrame frame;
  frame.not_drawn = not_drawn_text(plan);
  if (!plan.balls) throw std::runtime_error(frame.not_drawn);
  begin(context, kPreparing, 0.1);
  make_molecule(context);
  begin(context, kPreparing, 0.2);
  const BallGeometry& balls = *molecule_->geometry;
  const Clip clip = settings_.clip.resolved(balls.axes[2], balls.origin);
  const DrawnParts parts =
      make_parts({molecule_, answer, settings_.display, looks_, plan.mesh, clip}, paintings_,
                 make_mesh_, context);
  paintings_ = parts.paintings;
  missing_colours_ = parts.missing_colours(settings_.display.balls);
  frame.style = scene_style(settings_.display, settings_.theme);
  frame.style.line_scale = settings_.line_scale;
  frame.style.cut = Cut(clip, balls.origin);
  if (settings_.camera) frame.viewpoint = viewpoint_at(*settings_.camera, balls);
  frame.options = settings_.options;
  frame.layers = settings_.layers;
  frame.beside_body = beside_body_;
  frame.objects = objects_;
  frame.texts = std::move(texts);
  return picture_of(*molecule_, answer.get(), parts, std::move(frame));
}

std::string render_picture(const Picture& picture, const std::filesystem::path& path,
                           const RunContext& context) {
  begin(context, "drawing", 0.5);
  EglContext egl;
  Scene scene;
  const MarkedPicture marked = show(scene, picture);
  begin(context, "drawing", 0.7);
  const std::string left_out = write_picture(scene, marked, path, picture.texts, context);
  const bool both = !picture.not_drawn.empty() && !left_out.empty();
  return picture.not_drawn + (both ? " " : "") + left_out;
}

}  // namespace alphascope
