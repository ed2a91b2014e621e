// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which atoms are drawn beside the body.
#include "core/document/settings/display.hpp"

#include "core/selection/ball_options.hpp"
#include "core/selection/drop_reason.hpp"

namespace alphascope {

bool shows(const AtomsBesideBody& shown, DropReason reason, Element element) {
  if (element == kHydrogen && !shown.hydrogens) return false;
  switch (reason) {
    case DropReason::ligand:
      return shown.ligands;
    case DropReason::ion:
      return shown.ions;
    case DropReason::water:
      return shown.waters;
    case DropReason::hydrogen:
      return shown.hydrogens;
    default:
      return false;
  }
}

}  // namespace alphascope
