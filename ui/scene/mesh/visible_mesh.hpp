// The mesh of the part of a complex that has no hidden ball as a corner. Pure C++, may run in a
// worker; no VTK.
#pragma once

#include <functional>
#include <vector>

#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// build_mesh(), or what stands in for it.
using MeshBuild = std::function<ComplexMesh(const AlphaComplex& complex)>;

// `hidden`: one a ball; empty: none is. Outside and boundary are those of the tetrahedra that are
// left, so what is shown is closed. Cells name their simplices by the places in the whole complex.
ComplexMesh build_visible_mesh(const AlphaComplex& complex, const std::vector<bool>& hidden,
                               const MeshBuild& build);

// The same of what closes tetrahedra at a cut.
using CapBuild = std::function<CapMesh(const AlphaComplex& complex)>;
CapMesh build_visible_caps(const AlphaComplex& complex, const std::vector<bool>& hidden,
                           const CapBuild& build);

}  // namespace alphascope
