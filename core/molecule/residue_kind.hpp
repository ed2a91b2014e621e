// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of residues: polymer, water, ligand, ion and dummy.
#pragma once

#include <cstdint>

namespace alphascope {

// The kind of residue an atom belongs to. Dummies are markers without matter, such as OPM's
// membrane planes.
enum class ResidueKind : std::uint8_t { polymer, water, ligand, ion, dummy };

}  // namespace alphascope
