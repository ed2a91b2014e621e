// What is in the cavities: ligands, ions and waters that are not in the body.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/document/store/derived.hpp"

namespace alphascope {

// A ligand, an ion or a water. It counts as in the cavity whose tetrahedra hold the centres of most
// of its atoms, and of two that hold as many, in the one of the larger SA volume.
struct HeldResidue {
  std::uint32_t atom = 0;                  // its first atom that is left out, of Molecule::atoms
  DropReason kind = DropReason::ligand;    // or ion, water
  std::uint32_t cavity = Cavities::kNone;  // of found.cavities; kNone: no atom is in a cavity
  std::uint32_t atoms = 0, inside = 0;     // all that are left out; those in `cavity`
  friend bool operator==(const HeldResidue&, const HeldResidue&) = default;
};

struct CavityContents {
  std::vector<HeldResidue> residues;  // in the order of the molecule
  // Of each of found.cavities the indices of what it holds: ligands, then ions, then waters.
  std::vector<std::vector<std::uint32_t>> of;
};

// `atoms` are of the table's balls without solvent radius. Hydrogens of the body are no contents.
// Works in the caller's task arena. Throws Cancelled.
CavityContents find_contents(const BallReferences& atoms, const CavityTable& table,
                             const CancelToken& cancel = {});

// "A:HEM 142 (41 of 43 atoms), A:PO4 147, 5 waters": at most `most` names; "" of an empty cavity.
std::string contents_text(const Molecule& molecule, const CavityContents& contents,
                          std::uint32_t cavity, std::size_t most = 3);

// Of the table on screen (cavity_table()).
const Definition<CavityContents>& cavity_contents();

}  // namespace alphascope
