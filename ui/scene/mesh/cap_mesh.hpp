// SPDX-License-Identifier: GPL-3.0-or-later
// Flat faces that close tetrahedra where planes cut them. They are the intersections, in the
// colours of the tetrahedra. Pure C++, may run in a worker; no VTK.
#pragma once

#include <optional>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "ui/scene/cut.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

struct CapMesh {
  CellSoup faces;  // triangles; source: 4 × tetrahedron, a face code as in the mesh
  CellSoup edges;  // lines around each intersection, in a darker colour
};

// Whether a cut of this mesh has caps. Only tetrahedra and their boundary have.
bool has_caps(const MeshOptions& options);

// Same input as build_mesh(); `scale` is the scale of the mesh, if it has one.
CapMesh build_cap_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const std::optional<AlphaScale>& scale, const Cut& cut,
                       const CancelToken& cancel = {});

}  // namespace alphascope
