// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a molecule, and the geometry made from them for drawing.
#pragma once

#include <memory>

#include "app/session/open_molecule.hpp"
#include "core/run/cancel_token.hpp"
#include "ui/scene/pick/ball_pick.hpp"
#include "ui/scene/picture/painting.hpp"

namespace alphascope {

struct DrawnMolecule : PicturedMolecule {
  std::shared_ptr<const OpenedMolecule> opened;  // the source of the rest
  std::shared_ptr<const BallPicker> picker;      // picks in `geometry`
};

// Throws Cancelled.
std::shared_ptr<const DrawnMolecule> make_drawn(std::shared_ptr<const OpenedMolecule> opened,
                                                const RunContext& context);
// A molecule without balls, for too little memory.
std::shared_ptr<const DrawnMolecule> make_undrawn(std::shared_ptr<const OpenedMolecule> opened);

// Whether both are states of one sandbox, before and after an edit. The view then stays, so a
// dragged ball stays under the mouse. `before` may be null, here and in the next function.
bool changes_sandbox(const DrawnMolecule* before, const DrawnMolecule& now);

// Whether both molecules have the same balls. Two drawings that were begun before the first was
// shown both contain them.
bool has_same_balls(const DrawnMolecule* before, const DrawnMolecule& now);

}  // namespace alphascope
