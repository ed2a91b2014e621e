// What the mouse is on: each layer of the scene says what a line of sight meets first in it, and
// the nearest wins. On the CPU, from the arrays that are drawn; no VTK.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/pick/ball_pick.hpp"

namespace alphascope {

// A line of sight, and how far beside it a thin line still counts: Å for each length of the ray's
// direction.
struct PickLine {
  Ray ray;
  double spread = 0;
  Stretch kept = {};      // by the cut: nothing is hit elsewhere
  double rod_radius = 0;  // Å, of edges: more where they are thicker than that
};

inline constexpr std::string_view kBesideBody = "beside", kAtomInFront = "in front";

struct Hit {
  // "balls", "tetrahedra", "boundary", "triangles", "edges"; "beside", whose index is of
  // BesideBody::atoms; "in front", whose index is of Molecule::atoms; "bodies" of panels' layers,
  // of which nothing more is known.
  std::string_view layer;
  int corners = 1;        // 1: a ball; 0: a body
  std::size_t index = 0;  // of the ball, or of the simplex in its list of the complex
  // Of a boundary face, which is in no list where only tetrahedra are computed: `index` is its
  // tetrahedron, and this the corner that it lacks.
  std::optional<int> opposite;
  double depth = 0;            // in lengths of the ray's direction
  std::array<double, 3> at{};  // Å, relative to BallGeometry::origin
};

struct PickLayer {
  std::string_view id;
  std::function<std::optional<Hit>(const PickLine&)> pick;
};
using PickLayers = std::vector<PickLayer>;

// Of what is drawn as `mesh`. Any thread; about as long as a copy of the mesh takes.
PickLayers mesh_layers(const std::shared_ptr<const ComplexMesh>& mesh,
                       const std::shared_ptr<const BallGeometry>& balls);

// Of what closes tetrahedra in the planes of a cut.
PickLayer cap_layer(const std::shared_ptr<const CapMesh>& mesh);

// Of what is drawn as balls of their own; `id` as in Hit::layer.
PickLayer ball_layer(std::string_view id, std::shared_ptr<const BallGeometry> balls, int corners);
// Of bodies of panels' layers, which hide what is behind them.
PickLayers body_layers(const std::shared_ptr<const LayerMesh>& mesh);
// Of their atoms, which hide all else; none: there are none.
std::optional<PickLayer> atom_layer(const std::shared_ptr<const LayerMesh>& mesh);

// Of layers at the same depth the first wins.
std::optional<Hit> nearest_hit(const PickLayers& layers, const PickLine& line);

// The simplex of a hit that is no ball. Alpha value and class are unknown where only tetrahedra
// were computed.
struct HitSimplex {
  std::vector<BallIndex> balls;      // ascending
  std::optional<double> angstrom2;   // its alpha value, Å²
  std::optional<SimplexClass> kind;  // singular, regular or interior
};
HitSimplex hit_simplex(const Hit& hit, const AlphaComplex& complex);
// Whether the complex has this simplex, of 2 to 4 balls, ascending; one of its faces when only
// tetrahedra were computed cannot be told and counts as there.
bool has_simplex(const AlphaComplex& complex, const std::vector<BallIndex>& balls);

}  // namespace alphascope
