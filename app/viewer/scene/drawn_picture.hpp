// SPDX-License-Identifier: GPL-3.0-or-later
// The molecule and the complex on screen, with the parts of their picture. They change together,
// and may be older than the molecule and complex that were set last.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/viewer/scene/drawn_molecule.hpp"
#include "core/document/store/answer.hpp"
#include "core/write/write_complex.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/scene/cut.hpp"
#include "ui/scene/picture/drawn_parts.hpp"

namespace alphascope {

struct DrawnPicture {
  // Null before the first picture, and while memory is made free for the next.
  std::shared_ptr<const DrawnMolecule> molecule;
  std::shared_ptr<const Answer> answer;  // null: there is no complex
  DrawnParts parts;
  std::string not_drawn;  // parts missing for lack of memory, and the reason; empty: none

  bool draws_nothing() const;  // because memory is too small
  // Whether there is something to look at.
  bool any() const { return molecule && !draws_nothing(); }
  bool shows_complex() const { return parts.mesh && !parts.mesh->empty(); }
  Cut cut_of(const Clip& clip) const;
  Cut cut() const { return cut_of(parts.clip); }

  // Areas and volumes of the complex, if the colours of the balls depend on them; else null.
  std::shared_ptr<const MeasuredUnion> measures() const {
    return parts.paintings.balls ? parts.paintings.balls->measures : nullptr;
  }
  // Sentences on missing parts and missing colours; empty: nothing is missing.
  std::string lacks(bool with_balls) const;
  // Legends, ranges of colours, hidden balls, and the box around the balls.
  void describe(bool with_balls, ViewportInfo& viewport) const;
  // The provenance of the picture; empty if there is none.
  ComplexHeader header() const;
  // The header and all that the picture lacks, as texts of saved pictures.
  PictureTexts texts(bool with_balls) const;
};

// The provenance of an answer of this molecule.
ComplexHeader header_of(const OpenedMolecule& opened, const EngineAnswer& answer);

}  // namespace alphascope
