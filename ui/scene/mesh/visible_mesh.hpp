// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh of the part of a complex that has no hidden ball as a corner. Pure C++, may run in a
// worker; no VTK.
#pragma once

#include <functional>
#include <vector>

#include "ui/scene/mesh/cap_mesh.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"

namespace alphascope {

// build_mesh(), or a function in its place.
using MeshBuild = std::function<ComplexMesh(const AlphaComplex& complex)>;

// `hidden` has one value for each ball; empty: none is hidden. Outside and boundary are those of
// the visible tetrahedra, so the drawing is closed. Cells name simplices by their indices in the
// whole complex.
ComplexMesh build_visible_mesh(const AlphaComplex& complex, const std::vector<bool>& hidden,
                               const MeshBuild& build);

// The same for the caps of tetrahedra at a cut.
using CapBuild = std::function<CapMesh(const AlphaComplex& complex)>;
CapMesh build_visible_caps(const AlphaComplex& complex, const std::vector<bool>& hidden,
                           const CapBuild& build);

}  // namespace alphascope
