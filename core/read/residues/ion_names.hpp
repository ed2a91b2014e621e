// Names of ions, which are alone in their residue: those of the chemical component dictionary and
// of CHARMM, AMBER, GROMACS and CNS. In any case: AMBER writes "Na+" and GROMACS "NA+".
#pragma once

#include <string>
#include <string_view>

#include "core/molecule/element.hpp"

namespace alphascope {

// What a residue name says of the ion in it: "SOD", "NA+", "ZN2" and "3CO" are Na, Na, Zn and Co;
// kUnknownElement for a name that is no ion's. Other residues have such names too (CLA is chloride
// for CHARMM and chlorophyll in the PDB), so it counts only where the atom is that ion.
Element ion_of_residue(std::string_view residue_name);

// Residues named "ION" hold any ion.
bool is_any_ion(std::string_view residue_name);

// The element of an ion by the names of atom and residue, when they agree; else kUnknownElement.
// Names have no blanks around them. In "CA" of "CAL" it is calcium, in "CA" of "ALA" nothing.
Element ion_element(std::string_view residue_name, std::string_view atom_name);

// "NA+", "Cl-", "MG+2": a metal or a halide with its charge, whatever the residue.
Element charged_ion(std::string_view atom_name);

}  // namespace alphascope
