// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the thing under the mouse. Each layer of the scene finds its first intersection with a line
// of sight; the nearest wins. Works on the CPU, on the arrays that are drawn; no VTK.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"
#include "ui/scene/objects/object_mesh.hpp"
#include "ui/scene/pick/ball_pick.hpp"

namespace alphascope {

// A line of sight. `spread` is the distance at which a thin line still counts, in Å for each length
// of the ray's direction.
struct PickLine {
  Ray ray;
  double spread = 0;
  RayInterval kept = {};  // interval that the cut keeps; nothing is hit outside it
  double rod_radius = 0;  // Å, radius of edges; counts where it exceeds the spread
};

inline constexpr std::string_view kBesideBody = "beside", kAtomInFront = "in front";
inline constexpr std::string_view kAtomOfObject = "object", kBodies = "bodies", kTubes = "tubes";

struct Hit {
  // "balls", "tetrahedra", "boundary", "triangles", "edges"; "beside" (index in BesideBody::atoms);
  // "in front" and "object" (index in Molecule::atoms); "bodies" and "tubes" (index of the panel's
  // layer among those of LayerMesh).
  std::string_view layer;
  int corners = 1;        // 1: a ball; 0: a body
  std::size_t index = 0;  // of the ball, or of the simplex in its list in the complex
  // For a boundary face: the corner of tetrahedron `index` that is opposite to it. The face itself
  // has no index if only tetrahedra were computed.
  std::optional<int> opposite;
  double depth = 0;            // in lengths of the ray's direction
  std::array<double, 3> at{};  // Å, relative to BallGeometry::origin
};

struct PickLayer {
  std::string_view id;
  std::function<std::optional<Hit>(const PickLine&)> pick;
};
using PickLayers = std::vector<PickLayer>;

// Layers of the drawn mesh. Runs on any thread, in about the time of copying the mesh, with the
// threads of the caller's task arena. Throws Cancelled.
PickLayers mesh_layers(const std::shared_ptr<const ComplexMesh>& mesh,
                       const std::shared_ptr<const BallGeometry>& balls,
                       const CancelToken& cancel = {});

// The layer of caps, which close tetrahedra in the planes of a cut.
PickLayer cap_layer(const std::shared_ptr<const CapMesh>& mesh);

// A layer of balls; `id` as in Hit::layer.
PickLayer ball_layer(std::string_view id, std::shared_ptr<const BallGeometry> balls, int corners);
// Layers of the bodies that panels draw. Bodies hide things behind them.
PickLayers body_layers(const std::shared_ptr<const LayerMesh>& mesh);
// The layer of the atoms that panels draw in front of everything; none: there are no such atoms.
std::optional<PickLayer> atom_layer(const std::shared_ptr<const LayerMesh>& mesh);

// Layers of an object. A hit is on an atom: of a cartoon, on that of the residue's trace; of a
// stick, on the nearer end. Runs on any thread.
PickLayers object_layers(const std::shared_ptr<const ObjectMesh>& mesh);

// The nearest hit. At equal depth the first layer wins.
std::optional<Hit> nearest_hit(const PickLayers& layers, const PickLine& line);

// The simplex of a hit that is not a ball. Alpha value and class are unknown if only tetrahedra
// were computed.
struct HitSimplex {
  std::vector<BallIndex> balls;      // ascending
  std::optional<double> angstrom2;   // its alpha value, Å²
  std::optional<SimplexClass> kind;  // singular, regular or interior
};
HitSimplex hit_simplex(const Hit& hit, const AlphaComplex& complex);
// Whether the complex contains the simplex of these 2 to 4 balls, in ascending order. If only
// tetrahedra were computed, edges and triangles are unknown; the result is then true.
bool has_simplex(const AlphaComplex& complex, const std::vector<BallIndex>& balls);

}  // namespace alphascope
