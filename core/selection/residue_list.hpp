// What the residues of a molecule are and why, for lists that people read.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class ResidueListing : unsigned char {
  grouped,  // the polymer of a chain is one line, so are its waters, and many of one name
  each      // one line for each residue
};

struct ListedResidues {
  std::string chain, name, number;  // "16-223"; no name where there are several
  AtomKind kind = AtomKind::polymer;
  ResidueReason why = ResidueReason::none;
  std::size_t residues = 0, atoms = 0;
  std::size_t first_atom = 0;  // of the first of them
};

// Of the atoms [begin, end), in order of appearance. A residue whose atoms differ in what they are
// (an ion, a site without matter) stands there with each.
std::vector<ListedResidues> list_residues(const Molecule& molecule, std::size_t begin,
                                          std::size_t end, ResidueListing listing);

}  // namespace alphascope
