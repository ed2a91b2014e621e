// SPDX-License-Identifier: GPL-3.0-or-later
// Layers that panels ask for, as flat arrays. Pure C++, may run in a worker; no VTK.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/molecule/rgb8.hpp"
#include "ui/layer.hpp"
#include "ui/scene/mesh/ball_geometry.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/difference_mesh.hpp"
#include "ui/scene/mesh/tube_mesh.hpp"
#include "ui/scene/picture/placed_label.hpp"

namespace alphascope {

// For each of the layers, in their order: the number of its things and of those before it. Things
// are triangles of an array, or spheres.
using LayerEnds = std::vector<std::size_t>;
// The layer that this thing is of.
std::size_t layer_at(const LayerEnds& ends, std::size_t thing);

// Bodies are lit. Bounds and axes of `spheres` are not set.
struct LayerBodies {
  CellSoup faces;                               // triangles
  CellSoup edges;                               // of tetrahedra
  std::shared_ptr<const BallGeometry> spheres;  // null: none
  std::vector<Rgb8> sphere_colours;
  LayerEnds face_ends, sphere_ends;
  bool empty() const { return faces.points() == 0 && !spheres; }
};

struct LayerMesh {
  DifferenceMesh marks;  // drawn over everything else
  LayerBodies opaque, translucent;
  CellSoup body_lines;  // lines of layers that are bodies
  SmoothMesh tubes;
  LayerEnds tube_ends;
  // Atoms drawn in front of everything; null: none. Each has a colour and an index in
  // Molecule::atoms.
  std::shared_ptr<const BallGeometry> atoms;
  std::vector<Rgb8> atom_colours;
  std::vector<std::uint32_t> atom_of;
  std::vector<PlacedLabel> labels;
  bool fades_rest = false;
  bool has_bodies() const { return !opaque.empty() || !translucent.empty() || tubes.points() > 0; }
};

// Throws std::invalid_argument when a simplex has a vertex beyond the balls.
LayerMesh build_layer_mesh(const BallGeometry& balls, const Layers& layers);

// Upper bounds for the numbers of points in the arrays, found without making the arrays.
struct LayerPoints {
  std::size_t faces = 0, lines = 0, balls = 0;
  std::size_t all() const { return faces + lines + balls; }
};
LayerPoints layer_points(const Layers& layers);

}  // namespace alphascope
