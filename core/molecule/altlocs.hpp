// Choosing one of several alternative locations of the atoms of a residue.
#pragma once

#include <cstddef>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// For the atoms [begin, end): true where an atom gives way to another location. Per residue one
// letter is chosen: highest mean occupancy, then lowest mean B factor, then the first letter. An
// atom that does not have that letter keeps its own best one, unless it belongs to another residue
// type (microheterogeneity): then it goes with its letter.
std::vector<bool> minor_altlocs(const Molecule& molecule, std::size_t begin, std::size_t end);

}  // namespace alphascope
