// SPDX-License-Identifier: GPL-3.0-or-later
// Differences between two complexes, as flat arrays for drawing. Pure C++, may run in a worker; no
// VTK.
#pragma once

#include "core/complex/compare.hpp"
#include "core/molecule/rgb8.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// Colours that differ from those of all elements, chains and alpha values.
inline constexpr Rgb8 kMissingColour{255, 0, 190};  // in the reference only
inline constexpr Rgb8 kExtraColour{255, 225, 0};    // in the candidate only

struct DifferenceMesh {
  CellSoup faces;  // of triangles and tetrahedra; vertices as small octahedra
  CellSoup edges;  // lines
  bool empty() const { return faces.points() == 0 && edges.points() == 0; }
};

// Throws std::invalid_argument when a simplex has a vertex beyond the balls.
DifferenceMesh build_difference_mesh(const BallGeometry& balls, const Comparison& comparison);

}  // namespace alphascope
