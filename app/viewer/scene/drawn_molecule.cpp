// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the geometry for drawing, and compares molecules.
#include "app/viewer/scene/drawn_molecule.hpp"

#include <utility>

namespace alphascope {
namespace {

std::shared_ptr<const DrawnMolecule> drawn_as(std::shared_ptr<const OpenedMolecule> opened,
                                              std::shared_ptr<const BallGeometry> geometry) {
  auto drawn = std::make_shared<DrawnMolecule>();
  drawn->molecule = opened->molecule;
  drawn->prepared = opened->prepared;
  drawn->picker = std::make_shared<const BallPicker>(geometry);
  drawn->geometry = std::move(geometry);
  drawn->opened = std::move(opened);
  return drawn;
}

}  // namespace

std::shared_ptr<const DrawnMolecule> make_drawn(std::shared_ptr<const OpenedMolecule> opened,
                                                const RunContext& context) {
  auto geometry = std::make_shared<const BallGeometry>(*opened->prepared->balls);
  auto drawn = drawn_as(std::move(opened), std::move(geometry));
  context.cancel.throw_if_cancelled();
  return drawn;
}

std::shared_ptr<const DrawnMolecule> make_undrawn(std::shared_ptr<const OpenedMolecule> opened) {
  return drawn_as(std::move(opened), std::make_shared<const BallGeometry>());
}

bool changes_sandbox(const DrawnMolecule* before, const DrawnMolecule& now) {
  return before != nullptr && before->opened && now.opened && before->opened->options.sandbox &&
         now.opened->options.sandbox && before->opened->deposited == now.opened->deposited;
}

bool has_same_balls(const DrawnMolecule* before, const DrawnMolecule& now) {
  return before != nullptr && before->opened == now.opened && before->prepared == now.prepared &&
         before->geometry->centres.size() == now.geometry->centres.size();
}

}  // namespace alphascope
