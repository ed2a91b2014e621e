// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of cavities: ligands, ions and waters that are not balls of the body.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/selection/drop_reason.hpp"

namespace alphascope {

template <class T>
struct Definition;
class BallReferences;
struct CavityTable;
struct Molecule;

// A ligand, an ion or a water. It belongs to the cavity whose tetrahedra contain the centres of
// most of its atoms. On a tie it belongs to the cavity with the larger SA volume.
struct ContainedResidue {
  std::uint32_t atom = 0;                  // its first left-out atom, index in Molecule::atoms
  DropReason kind = DropReason::ligand;    // or ion, water
  std::uint32_t cavity = Cavities::kNone;  // index in found.cavities; kNone: no atom is in a cavity
  std::uint32_t atoms = 0, inside = 0;     // number of left-out atoms; number of those in `cavity`
  friend bool operator==(const ContainedResidue&, const ContainedResidue&) = default;
};

struct CavityContents {
  std::vector<ContainedResidue> residues;  // in the order of the molecule
  // For each of found.cavities, indices of the residues in it: ligands, then ions, then waters.
  std::vector<std::vector<std::uint32_t>> of;
};

// `atoms` refer to the table's balls without solvent radius. Hydrogens of the body are not
// contents. Uses the caller's task arena. Throws Cancelled.
CavityContents find_contents(const BallReferences& atoms, const CavityTable& table,
                             const CancelToken& cancel = {});

// "A:HEM 142 (41 of 43 atoms), A:PO4 147, 5 waters": at most `most` names; empty for an empty
// cavity.
std::string contents_text(const Molecule& molecule, const CavityContents& contents,
                          std::uint32_t cavity, std::size_t most = 3);

// Contents of the cavities of cavity_table().
const Definition<CavityContents>& cavity_contents();

}  // namespace alphascope
