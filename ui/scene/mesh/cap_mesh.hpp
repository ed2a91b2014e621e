// The flat faces with which a cut closes tetrahedra: what each of its planes and each tetrahedron
// have in common, in the tetrahedron's colour. Pure C++, may run in a worker; no VTK.
#pragma once

#include <optional>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "ui/scene/cut.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

struct CapMesh {
  CellSoup faces;  // triangles; their source is 4 × tetrahedron, as that of tetrahedra
  CellSoup edges;  // lines around each tetrahedron's face, darker
};

// Whether a cut of this mesh has caps: faces without tetrahedra have none.
bool has_caps(const MeshOptions& options);

// Input as of build_mesh(); `scale` is that of the mesh, if it has one.
CapMesh build_cap_mesh(const BallGeometry& balls, const std::vector<Rgb8>& colours,
                       const AlphaComplex& complex, const MeshOptions& options,
                       const std::optional<AlphaScale>& scale, const Cut& cut,
                       const CancelToken& cancel = {});

}  // namespace alphascope
