// SPDX-License-Identifier: GPL-3.0-or-later
// Names of ions, which are alone in their residue. They are those of the chemical component
// dictionary, CHARMM, AMBER, GROMACS and CNS. Case does not matter: AMBER writes "Na+" and GROMACS
// "NA+".
#pragma once

#include <string>
#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

// The ion of a residue name: "SOD", "NA+", "ZN2" and "3CO" are Na, Na, Zn and Co. kUnknownElement
// for other names. Other residues can have such names too, so the name counts only where the atom
// is that ion. CLA is chloride for CHARMM and chlorophyll in the PDB.
Element ion_of_residue(std::string_view residue_name);

// True for residues named "ION", which hold any ion.
bool is_any_ion(std::string_view residue_name);

// The element of an ion, when the names of atom and residue agree; else kUnknownElement. Names have
// no blanks around them. "CA" is calcium in "CAL", but no ion in "ALA".
Element ion_element(std::string_view residue_name, std::string_view atom_name);

// The element of "NA+", "Cl-" or "MG+2": a metal or halide with its charge, in any residue.
Element charged_ion(std::string_view atom_name);

}  // namespace alphascope
