// SPDX-License-Identifier: GPL-3.0-or-later
// Atoms of the molecule that are not balls of the complex, such as ligands that the options leave
// out. They are drawn as small balls with sticks for bonds, so that nobody takes them for balls of
// the complex. Pure C++, may run in a worker; no VTK.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/document/settings/display.hpp"
#include "core/molecule/bond.hpp"
#include "core/run/cancel_token.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"

namespace alphascope {

struct BesideBody {
  // Balls and sticks in the colours of elements; null: nothing is drawn.
  std::shared_ptr<const LayerMesh> mesh;
  std::vector<LeftOutAtom> atoms;  // one per sphere of the mesh; ascending
};

// Draws the atoms that `prepared` left out, of the kinds that `shown` contains. `balls` is the
// geometry of `prepared`, and `bonds` are those of the molecule, as find_bonds() lists them.
// Without balls the result is empty.
BesideBody build_beside_body(const BallGeometry& balls, const Molecule& molecule,
                             const PreparedBalls& prepared, std::span<const Bond> bonds,
                             const AtomsBesideBody& shown, const CancelToken& cancel = {});

}  // namespace alphascope
