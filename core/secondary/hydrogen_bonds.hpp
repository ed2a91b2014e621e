// SPDX-License-Identifier: GPL-3.0-or-later
// Hydrogen bonds between the backbones of residues, as DSSP defines them (W. Kabsch, C. Sander,
// Biopolymers 22, 2577-2637, 1983).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "core/secondary/backbone.hpp"

namespace alphascope {

// The two C=O groups with the lowest energies to which the N-H of a residue is bonded.
struct HydrogenBonds {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::array<std::uint32_t, 2> acceptor{kNone, kNone};       // indices of residues
  std::array<double, 2> energy_kilocalories_per_mole{0, 0};  // below -0.5, or 0 without acceptor
  bool accepts(std::uint32_t residue) const {
    return acceptor[0] == residue || acceptor[1] == residue;
  }
};

struct HydrogenBondList {
  std::vector<HydrogenBonds> of_donor;  // per residue
  // Residues with so many others at one place that not all were tried.
  std::size_t crowded = 0;
};

// Places the hydrogens, and takes time linear in the residues, which must be complete. Throws
// Cancelled.
HydrogenBondList find_hydrogen_bonds(const Molecule& molecule,
                                     const std::vector<BackboneResidue>& residues,
                                     const RunContext& context);

}  // namespace alphascope
