// SPDX-License-Identifier: GPL-3.0-or-later
// A bond between two atoms. The room core/bonds finds the bonds of a molecule.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alphascope {

enum class BondOrder : std::uint8_t { unknown, one, two, three, aromatic };

enum class BondKind : std::uint8_t {
  covalent,
  coordination  // between a metal and its ligand
};

// In the order in which evidence counts.
enum class BondReason : std::uint8_t {
  file,        // CONECT, LINK, SSBOND, struct_conn or a list of bonds
  residue,     // the known structure of a standard residue
  chain_link,  // C to N or O3' to P of neighbours in a chain, near enough for a bond
  distance     // a guess by covalent radii
};
inline constexpr std::size_t kBondReasons = 4;

// Twelve bytes, because a molecule may have 16 million bonds.
struct Bond {
  std::uint32_t a = 0, b = 0;  // indices of atoms, a < b
  BondOrder order = BondOrder::unknown;
  BondKind kind = BondKind::covalent;
  BondReason why = BondReason::distance;
  friend bool operator==(const Bond&, const Bond&) = default;
};
static_assert(sizeof(Bond) == 12);

}  // namespace alphascope
