// SPDX-License-Identifier: GPL-3.0-or-later
// The nucleotides of a model with the atoms that a ladder is drawn through.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/backbone.hpp"

namespace alphascope {

// Indices into Molecule::atoms; kNoAtom: not in the file.
struct Nucleotide {
  std::uint32_t backbone = kNoAtom;  // C4', else P, else C1'; never kNoAtom
  std::uint32_t sugar = kNoAtom;     // C1'
  std::uint32_t base = kNoAtom;      // N1 of purines, N3 of pyrimidines
  // The ring atoms of the base along its outline: N1 C2 N3 C4 C5 C6, and for purines N1 C2 N3 C4 N9
  // C8 N7 C5 C6. All are known, or `corners` is 0.
  std::array<std::uint32_t, 9> outline{};
  std::uint8_t corners = 0;  // 0, 6 or 9
  // The next nucleotide in the list follows in the same chain, and the backbone atoms are near
  // enough (kLongestNucleotideStep).
  bool bound_to_next = false;
};

inline constexpr double kLongestNucleotideStep = 9;  // Å; consecutive C4' or P are 5 to 8 Å apart

// Residues of polymers with C1' or, if the name is a nucleotide's, with C4' or P. In the order of
// the file, all copies of an assembly. Takes time linear in the atoms. Throws Cancelled.
std::vector<Nucleotide> find_nucleotides(const Molecule& molecule, const ModelRange& model,
                                         const RunContext& context = {});

}  // namespace alphascope
