// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of an atom for which the chosen radii set has no value, with its source.
#pragma once

#include "core/radii/radii_set.hpp"

namespace alphascope {

// The radius is always > 0 and marked guessed.
//
// Sets made for biomolecules (ProtOr, NACCESS, RasMol, AMBER, a user's table) have no metals. With
// them a metal, or a halide alone in its residue, is an ion with ligands at bonding distance. It
// gets its ionic radius, as in ChimeraX. So it touches its ligands instead of swallowing them, and
// the site of an absent ligand stays open. In the van der Waals sets (Bondi, Alvarez) it stays an
// atom on the scale of those sets.
AssignedRadius fallback_radius(RadiiSet set, Element element, ResidueKind kind);

// Bondi's own value, 10^-3 Å; 0: none.
int bondi_milliangstrom(Element element);

}  // namespace alphascope
