// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of secondary structure, and the runs of residues to which a file gives one. The room
// core/secondary decides the kind of each residue.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alphascope {

// In the order of the codes below.
enum class SecondaryStructure : std::uint8_t {
  coil,
  bend,
  turn,
  polyproline,      // left-handed helix of polyproline II
  three_ten_helix,  // hydrogen bonds from residue i + 3 to i
  pi_helix,         // from i + 5 to i
  alpha_helix,      // from i + 4 to i; a file's helices of other classes as well
  bridge,           // a single pair of a ladder
  strand
};
inline constexpr std::size_t kSecondaryStructures = 9;

// DSSP's letters: ' ', S, T, P, G, I, H, B, E.
inline char secondary_code(SecondaryStructure kind) {
  return " STPGIHBE"[static_cast<std::size_t>(kind)];
}
inline bool is_helix(SecondaryStructure kind) {
  return kind == SecondaryStructure::three_ten_helix || kind == SecondaryStructure::pi_helix ||
         kind == SecondaryStructure::alpha_helix;
}

// Residues in the order of the file, of one chain: those of the deposited atoms [begin, end).
struct SecondaryRange {
  std::uint32_t begin = 0, end = 0;
  SecondaryStructure kind = SecondaryStructure::coil;
  friend bool operator==(const SecondaryRange&, const SecondaryRange&) = default;
};

}  // namespace alphascope
