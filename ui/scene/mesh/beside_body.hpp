// Atoms that are there and no part of the body, such as ligands that the options leave out: drawn
// as small balls with sticks for bonds, so that they cannot be taken for balls of the complex. Pure
// C++, may run in a worker; no VTK.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/document/settings/display.hpp"
#include "core/run/cancel_token.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/scene/mesh/layer_mesh.hpp"

namespace alphascope {

struct BesideBody {
  // Balls and sticks in the colours of elements; null: nothing is drawn.
  std::shared_ptr<const LayerMesh> mesh;
  std::vector<LeftOutAtom> atoms;  // one a ball; ascending
};

// Of `prepared`, those kinds of left out atoms that `shown` has. `balls` is the geometry of
// `prepared`, without which there is no place to draw at: nothing for an empty one.
BesideBody build_beside_body(const BallGeometry& balls, const Molecule& molecule,
                             const PreparedBalls& prepared, const AtomsBesideBody& shown,
                             const CancelToken& cancel = {});

}  // namespace alphascope
