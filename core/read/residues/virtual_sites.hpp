// Points of force fields and of other programs that stand in a file as atoms but are none: virtual
// sites, lone pairs, Drude particles, dummy masses, pseudo-atoms, fpocket's alpha spheres.
#pragma once

#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/stated_element.hpp"

namespace alphascope {

// Whether an atom is such a point, by its names and what its file says of its element. A file that
// states an element is believed; so is one that states none by an X, but for atoms of residues
// that are known, and for unknown atoms (UNX): those are atoms of no known element.
bool is_virtual_site(const AtomNaming& naming, Statement stated);

// What only the neighbours tell: a Drude particle is named after its atom ("DCA" of CA) and stands
// on it; so does the site OM of a water's OH2. For molecules whose atoms have their places; before
// it is decided what their residues are.
void mark_sites_on_their_atoms(Molecule& molecule);

// Says how many atoms of all get no ball, once residues are decided.
void finish_virtual_sites(Molecule& molecule);

}  // namespace alphascope
