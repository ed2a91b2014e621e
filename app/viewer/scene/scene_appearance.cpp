// Hidden atoms and colours chosen by the user. They come with the next drawing, so that balls and
// simplices change together.
#include <utility>

#include "app/viewer/scene/scene_controller.hpp"
#include "ui/scene/mesh/visible_mesh.hpp"

namespace alphascope {

void SceneController::set_appearance(const Appearance& appearance) {
  if (std::exchange(appearance_, appearance) == appearance) return;
  submit();
  submit_beside_body();
}

// Runs on the worker's thread. Null: no atom is hidden, and no colour is chosen.
std::shared_ptr<const BallAppearance> SceneController::make_looks(const DrawnMolecule& molecule,
                                                                  const Appearance& appearance) {
  if (appearance.plain()) return nullptr;
  return std::make_shared<const BallAppearance>(
      ball_appearance(*molecule.molecule, molecule.prepared->atom_of_ball, appearance));
}

const std::vector<bool>& SceneController::hidden_of(const BallAppearance* looks) {
  static const std::vector<bool> none;
  return looks ? looks->hidden : none;
}

std::vector<float> SceneController::radii_of(const DrawnMolecule& molecule, const BallStyle& style,
                                             const BallAppearance* looks) {
  return shown_radii(drawn_radii(*molecule.geometry, style), looks);
}

ComplexMesh SceneController::make_mesh(const DrawnMolecule& molecule,
                                       const std::vector<Rgb8>& colours,
                                       const AlphaComplex& complex, const MeshOptions& options,
                                       const BallAppearance* looks,
                                       const CancelToken& cancel) const {
  return build_visible_mesh(complex, hidden_of(looks), [&](const AlphaComplex& part) {
    return make_mesh_(*molecule.geometry, colours, part, options, cancel);
  });
}

}  // namespace alphascope
