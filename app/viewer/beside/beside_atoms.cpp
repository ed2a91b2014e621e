// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the drawing of the atoms that are no balls.
#include "app/viewer/beside/beside_atoms.hpp"

namespace alphascope {

void BesideAtoms::follow(const SceneControls& controls) {
  if (!picture_.molecule || picture_.molecule->prepared->left_out.empty()) {
    worker_.cancel();
    return;
  }
  worker_.submit([this, drawn = picture_.molecule, shown = controls.display.beside,
                  hidden = controls.appearance.hidden](const RunContext& c) -> Worker::Delivery {
    BesideBody atoms =
        build_beside_body(*drawn->geometry, *drawn->molecule,
                          left_out_and_shown(*drawn->molecule, *drawn->prepared, hidden),
                          facts_.of(*drawn, c)->bonds, shown, c.cancel);
    std::optional<PickLayer> pick;
    if (atoms.mesh) pick = ball_layer(kBesideBody, atoms.mesh->opaque.spheres, 1);
    return [this, drawn, pick, data = make_layer_data(atoms.mesh), atoms] {
      if (drawn != picture_.molecule) return;
      body_ = atoms;
      pick_ = pick;
      canvas_.change().set_beside_body(data);
    };
  });
}

void BesideAtoms::forget() {
  worker_.cancel();
  body_ = {};
  pick_.reset();
}

}  // namespace alphascope
