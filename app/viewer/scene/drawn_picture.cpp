// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the picture on screen for panels and for saved pictures.
#include "app/viewer/scene/drawn_picture.hpp"

#include "app/session/result_header.hpp"
#include "ui/colour_legend.hpp"

namespace alphascope {

bool DrawnPicture::draws_nothing() const {
  return molecule && molecule->geometry->centres.empty() && !not_drawn.empty();
}

Cut DrawnPicture::cut_of(const Clip& clip) const {
  return molecule ? Cut(clip, molecule->geometry->origin) : Cut();
}

std::string DrawnPicture::lacks(bool with_balls) const {
  if (draws_nothing()) return not_drawn;
  return with_sentences(not_drawn, parts.missing_colours(with_balls));
}

void DrawnPicture::describe(bool with_balls, ViewportInfo& viewport) const {
  const auto& painting = parts.paintings.balls;
  const std::optional<ColourMeaning> balls =
      with_balls && painting ? painting->balls.key : std::nullopt;
  const std::optional<ColourMeaning> simplices = parts.simplex_key();
  const auto range = [](const std::optional<ColourMeaning>& key) {
    return key && key->scale ? std::optional(key->scale->range) : std::nullopt;
  };
  viewport.legends = legends_of(balls, simplices);
  viewport.ball_range = range(balls);
  viewport.simplex_range = range(simplices);
  viewport.hidden_balls = parts.looks ? parts.looks->hidden_balls : 0;
  if (!molecule) return;
  const BallGeometry& of = *molecule->geometry;
  for (std::size_t k = 0; k < 3; ++k) {
    viewport.box_middle[k] = of.origin[k] + (of.bounds[2 * k] + of.bounds[2 * k + 1]) / 2;
    viewport.box_half[k] = (of.bounds[2 * k + 1] - of.bounds[2 * k]) / 2;
  }
}

ComplexHeader DrawnPicture::header() const {
  if (!molecule) return {};
  const OpenedMolecule& opened = *molecule->opened;
  if (answer) return header_of(opened, *answer);
  const Provenance balls =
      provenance(*opened.molecule, opened.options.balls, opened.prepared->report);
  ComplexHeader header{{"program", program_text("alphascope")}};
  header.insert(header.end(), balls.begin(), balls.end());
  return header;
}

PictureTexts DrawnPicture::texts(bool with_balls) const {
  if (!molecule) return {};
  PictureTexts texts = picture_texts(header());
  note_missing(texts, parts, with_balls, not_drawn);
  return texts;
}

ComplexHeader header_of(const OpenedMolecule& opened, const EngineAnswer& answer) {
  return result_header("alphascope",
                       provenance(*opened.molecule, opened.options.balls, opened.prepared->report),
                       opened.molecule->notes, answer);
}

}  // namespace alphascope
