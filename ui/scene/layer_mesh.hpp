// What panels want drawn, as flat arrays. Pure C++, may run in a worker; no VTK.
#pragma once

#include <memory>
#include <vector>

#include "ui/layer.hpp"
#include "ui/scene/ball_geometry.hpp"
#include "ui/scene/complex_mesh.hpp"
#include "ui/scene/difference_mesh.hpp"
#include "ui/scene/placed_label.hpp"
#include "ui/scene/tube_mesh.hpp"

namespace alphascope {

struct LayerMesh {
  DifferenceMesh marks;  // over everything else
  CellSoup bodies;       // triangles, lit
  CellSoup body_edges;   // of the tetrahedra that are bodies
  CellSoup body_lines;   // edges of layers that are bodies
  SmoothMesh tubes;
  // Lit balls; their bounds and axes are not set.
  std::shared_ptr<const BallGeometry> spheres;  // null: none
  std::vector<Rgb8> sphere_colours;
  std::vector<PlacedLabel> labels;
  bool fades_rest = false;
  bool has_bodies() const { return bodies.points() > 0 || tubes.points() > 0 || spheres; }
};

// Throws std::invalid_argument when a simplex has a vertex beyond the balls.
LayerMesh build_layer_mesh(const BallGeometry& balls, const Layers& layers);

// Points of all arrays, at most; without making them.
struct LayerPoints {
  std::size_t faces = 0, lines = 0, balls = 0;
  std::size_t all() const { return faces + lines + balls; }
};
LayerPoints layer_points(const Layers& layers);

}  // namespace alphascope
