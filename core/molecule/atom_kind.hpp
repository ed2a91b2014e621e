// The kinds of atoms.
#pragma once

#include <cstdint>

namespace alphascope {

// The kind of residue an atom belongs to. Dummies are markers without matter, such as OPM's
// membrane planes.
enum class AtomKind : std::uint8_t { polymer, water, ligand, ion, dummy };

}  // namespace alphascope
