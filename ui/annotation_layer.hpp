// SPDX-License-Identifier: GPL-3.0-or-later
// Makes one layer of labels, distances, angles, marks and the power diagram, for the window and for
// saved pictures. Also makes the texts of measured numbers. No ImGui, no VTK.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/document/reference/annotations.hpp"
#include "ui/layer.hpp"

namespace alphascope {

// "3.812 Å", "109.5°", "−57.3°", "undefined". Without `of`: "not in this molecule".
std::string measured_text(const Measurement& m, const std::optional<Measured>& of);

// "Distance A:HIS 87:NE2 – A:HEM 142:FE: 2.143 Å".
std::string measurement_text(const Molecule& molecule, const Measurement& m);

struct AnnotatedPicture {
  const BallReferences& atoms;
  std::shared_ptr<const BallSet> balls;  // of the complex in the picture
  // Whether an atom is drawn, by index into the molecule's atoms. A measurement is drawn if all of
  // its atoms are.
  std::function<bool(std::size_t)> is_drawn;
  Colour colour;  // of the lines
  std::uint64_t key = 0;
  // Balls grown by the solvent radius, for the power diagram; null: the radii of `balls` include
  // it.
  std::shared_ptr<const BallSet> grown = nullptr;
};
// Null if there is nothing to draw.
std::shared_ptr<const Layer> make_annotation_layer(const Annotations& annotations,
                                                   const AnnotatedPicture& picture);

}  // namespace alphascope
