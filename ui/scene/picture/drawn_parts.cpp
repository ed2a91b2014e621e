// SPDX-License-Identifier: GPL-3.0-or-later
// Makes colours, radii, mesh and caps of one complex, and a picture of them.
#include "ui/scene/picture/drawn_parts.hpp"

#include <chrono>
#include <utility>

#include "core/complex/own_dimension.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/run/freed_on_other_thread.hpp"
#include "ui/caption.hpp"
#include "ui/colour_legend.hpp"
#include "ui/scene/display_style.hpp"
#include "ui/scene/mesh/visible_mesh.hpp"

namespace alphascope {
namespace {

const std::vector<bool>& hidden_of(const BallAppearance* looks) {
  static const std::vector<bool> none;
  return looks ? looks->hidden : none;
}

// A copy only where looks change colours: copying a million takes milliseconds.
ColoursOfBalls colours_of(const std::shared_ptr<const Painting>& painting,
                          const BallAppearance* looks) {
  const std::vector<Rgb8>& colours = painting->balls.colours;
  if (looks == nullptr) return {painting, &colours};
  return std::make_shared<const std::vector<Rgb8>>(painted(colours, looks));
}

void make_mesh_of(const PartsTask& task, const Paintings& earlier, const MeshMaker& make_mesh,
                  const RunContext& context, DrawnParts& parts) {
  const auto begun = std::chrono::steady_clock::now();
  if (task.mesh.colouring == ComplexColouring::balls) {
    const Paint& paint = task.display.complex_paint;
    const bool as_balls = paint == task.display.ball_paint;
    parts.paintings.simplices =
        make_painting({task.molecule, task.answer, paint},
                      as_balls ? parts.paintings.balls : earlier.simplices, context);
  }
  const Paintings& made = parts.paintings;
  parts.simplex_colours =
      colours_of(made.simplices ? made.simplices : made.balls, parts.looks.get());
  const InOwnDimension own(*task.answer->balls, task.answer->complex);
  parts.options = task.mesh;
  parts.mesh = freed_on_other_thread(build_visible_mesh(
      own.complex(), hidden_of(parts.looks.get()), [&](const AlphaComplex& part) {
        return make_mesh(*task.molecule->geometry, *parts.simplex_colours, part, task.mesh,
                         context.cancel);
      }));
  parts.mesh_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace

std::shared_ptr<const BallAppearance> make_ball_appearance(const PicturedMolecule& molecule,
                                                           const Appearance& appearance) {
  if (appearance.plain()) return nullptr;
  return std::make_shared<const BallAppearance>(
      ball_appearance(*molecule.molecule, molecule.prepared->atom_of_ball, appearance));
}

std::vector<Rgb8> DrawnParts::ball_colours(std::size_t balls) const {
  return painted(
      paintings.balls ? paintings.balls->balls.colours : std::vector<Rgb8>(balls, kNoValueColour),
      looks.get());
}

std::optional<ColourMeaning> DrawnParts::simplex_key() const {
  if (!mesh) return std::nullopt;
  return mesh_colour_meaning(*mesh, options,
                             paintings.simplices ? paintings.simplices->balls.key : std::nullopt);
}

std::vector<std::string> DrawnParts::missing_colours(bool with_balls) const {
  std::vector<std::string> sentences;
  const auto add = [&sentences](const Painting& painting) {
    const std::string& lacks = painting.balls.lacks;
    if (!lacks.empty() && (sentences.empty() || sentences.front() != lacks)) {
      sentences.push_back(lacks);
    }
  };
  if (with_balls && paintings.balls) add(*paintings.balls);
  if (mesh && !mesh->empty() && paintings.simplices) add(*paintings.simplices);
  return sentences;
}

DrawnParts make_parts(const PartsTask& task, const Paintings& earlier, const MeshMaker& make_mesh,
                      const RunContext& context) {
  DrawnParts parts;
  parts.looks = task.looks;
  parts.clip = task.clip;
  if (task.with_radii) set_radii(parts, *task.molecule, task.answer.get(), task.display);
  parts.paintings.balls =
      make_painting({task.molecule, task.answer, task.display.ball_paint}, earlier.balls, context);
  if (!task.answer) return parts;
  make_mesh_of(task, earlier, make_mesh, context, parts);
  parts.caps = make_caps(*task.molecule, task.answer.get(), parts, task.clip, context.cancel);
  return parts;
}

void set_radii(DrawnParts& parts, const PicturedMolecule& molecule, const EngineAnswer* answer,
               const DisplaySettings& display) {
  parts.ball_scale = display.ball_scale;
  parts.grown_balls = display.grown_balls;
  const BallStyle style = ball_style(display, answer ? &answer->request : nullptr);
  parts.radii = shown_radii(drawn_radii(*molecule.geometry, style), parts.looks.get());
}

std::shared_ptr<const CapMesh> make_caps(const PicturedMolecule& molecule,
                                         const EngineAnswer* answer, const DrawnParts& parts,
                                         const Clip& clip, const CancelToken& cancel) {
  if (!clip.on() || answer == nullptr || !parts.mesh || !has_caps(parts.options)) return nullptr;
  const Cut cut(clip, molecule.geometry->origin);
  return std::make_shared<const CapMesh>(build_visible_caps(
      answer->complex, hidden_of(parts.looks.get()), [&](const AlphaComplex& part) {
        return build_cap_mesh(*molecule.geometry, *parts.simplex_colours, part, parts.options,
                              parts.mesh->scale, cut, cancel);
      }));
}

Picture picture_of(const PicturedMolecule& molecule, const EngineAnswer* answer,
                   const DrawnParts& parts, PictureFrame frame) {
  const PictureOptions& options = frame.options;
  Picture picture;
  picture.balls = molecule.geometry;
  picture.colours = parts.ball_colours(molecule.geometry->centres.size());
  picture.radii = parts.radii;
  picture.mesh = parts.mesh;
  picture.caps = parts.caps;
  picture.differences = parts.differences;
  picture.layers = std::move(frame.layers);
  picture.beside_body = std::move(frame.beside_body);
  picture.objects = std::move(frame.objects);
  picture.layer_objects = std::move(frame.layer_objects);
  picture.style = std::move(frame.style);
  picture.viewpoint = frame.viewpoint;
  MarkedPicture& marked = picture.picture;
  marked.width = options.width;
  marked.height = options.height;
  marked.dpi = options.dpi;
  marked.background = options.background;
  marked.letters = static_cast<float>(options.letters);
  if (!options.background.transparent) picture.style.background = options.background.colour;
  marked.theme = picture.style.theme;
  marked.scale_bar = options.scale_bar;
  marked.cut = picture.style.cut;
  const bool ball_key = picture.style.balls && parts.paintings.balls;
  if (options.legend) {
    marked.legends =
        legends_of(ball_key ? parts.paintings.balls->balls.key : std::nullopt, parts.simplex_key());
  }
  if (answer != nullptr) {
    marked.caption = caption_words(*answer, *molecule.molecule,
                                   molecule.prepared->report.radii_name, options.caption);
  }
  picture.texts = std::move(frame.texts);
  note_missing(picture.texts, parts, picture.style.balls, frame.not_drawn);
  picture.not_drawn = std::move(frame.not_drawn);
  return picture;
}

void note_missing(PictureTexts& texts, const DrawnParts& parts, bool with_balls,
                  const std::string& not_drawn) {
  if (parts.looks && parts.looks->hidden_balls > 0) {
    texts.emplace_back("Hidden atoms", std::to_string(parts.looks->hidden_balls));
  }
  const std::string lacks = with_sentences(not_drawn, parts.missing_colours(with_balls));
  if (!lacks.empty()) texts.emplace_back("Warning", lacks);
}

std::string with_sentences(std::string text, const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    if (sentence.empty() || text.find(sentence) != std::string::npos) continue;
    text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

}  // namespace alphascope
