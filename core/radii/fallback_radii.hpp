// What an atom gets when the chosen radii set has no value for it, and where that comes from.
#pragma once

#include "core/radii/radii_set.hpp"

namespace alphascope {

// Always > 0 and marked guessed, with its source.
//
// Sets made for biomolecules (ProtOr, NACCESS, RasMol, AMBER, a user's table) name no metals. There
// a metal, or a halide that is alone in its residue, is an ion with its ligands at bonding
// distance: it gets its ionic radius, as in ChimeraX, so that it touches its ligands instead of
// swallowing them, and the site of a ligand that is absent stays open. In the van der Waals sets
// (Bondi, Alvarez) it stays an atom on the scale of those sets.
AssignedRadius fallback_radius(RadiiSet set, Element element, AtomKind kind);

// Bondi's own value, 10^-3 Å; 0 = none.
int bondi_milliangstrom(Element element);

}  // namespace alphascope
