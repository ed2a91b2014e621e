// SPDX-License-Identifier: GPL-3.0-or-later
// Points that a file lists as atoms but that are none. They are virtual sites, lone pairs, Drude
// particles, dummy masses, pseudo-atoms, and alpha spheres of fpocket.
#pragma once

#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/stated_element.hpp"

namespace alphascope {

// True for such a point, by its names and its stated element. An atom with a stated element is no
// such point. An X instead of an element makes a point only in an unknown residue. In known
// residues, and for unknown atoms (UNX), it is an atom of no known element.
bool is_virtual_site(const AtomNaming& naming, ElementStatement stated);

// Marks points that only their neighbours show. A Drude particle is named after its atom ("DCA" for
// CA) and lies on it. The site OM of a water lies on its OH2. Atoms must be on the lattice, and
// residues not yet decided.
void mark_sites_at_atoms(Molecule& molecule);

// Adds a note with the number of atoms that get no ball. Residues must be decided.
void finish_virtual_sites(Molecule& molecule);

}  // namespace alphascope
