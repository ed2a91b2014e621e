// SPDX-License-Identifier: GPL-3.0-or-later
// The class of an atom's residue. Amino acids have Lesk's classes (Introduction to Bioinformatics,
// Oxford University Press, 2002); other residues have further ones.
#pragma once

#include <array>
#include <cstdint>

#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class ResidueClass : std::uint8_t {
  small_nonpolar,  // Gly, Ala, Ser, Thr
  hydrophobic,     // Cys, Val, Ile, Leu, Pro, Phe, Tyr, Met, Trp
  polar,           // Asn, Gln, His
  negative,        // Asp, Glu
  positive,        // Lys, Arg
  nucleotide,
  other,  // in a polymer, but none of these
  ligand,
  ion,
  water,
  dummy
};
inline constexpr std::size_t kResidueClasses = 11;

ResidueClass residue_class(const Molecule& molecule, const Atom& atom);

const char* residue_class_name(ResidueClass kind);  // "small non-polar"
// Lesk's hues in the shades of Okabe and Ito. Other residues have further colours.
Rgb8 residue_class_colour(ResidueClass kind);

}  // namespace alphascope
