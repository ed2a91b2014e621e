// Choosing one of several alternative locations of the atoms of a residue.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// For the atoms [begin, end): true where an atom gives way to another location. Per residue one
// letter is chosen: highest mean occupancy, then lowest mean B factor, then the first letter. An
// atom that does not have that letter keeps its own best one, unless it belongs to another residue
// type (microheterogeneity): then it goes with its letter.
//
// Residues that share chain and number are told apart by their segment, by numbers that begin anew
// between them (10,000 waters in four columns), and by an atom that both have.
//
// Only atoms that `compete` says true of take part (none given: all): who asks for the letter B
// gets it, and who leaves out A gets what is left.
std::vector<bool> minor_altlocs(const Molecule& molecule, std::size_t begin, std::size_t end,
                                const std::function<bool(const Atom&)>& compete = {});

}  // namespace alphascope
