// What kind of residue an atom is of: Lesk's classes of amino acids (Introduction to
// Bioinformatics, Oxford University Press, 2002), and what is no amino acid.
#pragma once

#include <array>
#include <cstdint>

#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {

enum class ResidueKind : std::uint8_t {
  small_nonpolar,  // Gly, Ala, Ser, Thr
  hydrophobic,     // Cys, Val, Ile, Leu, Pro, Phe, Tyr, Met, Trp
  polar,           // Asn, Gln, His
  negative,        // Asp, Glu
  positive,        // Lys, Arg
  nucleotide,
  other,  // of a polymer, and none of these
  ligand,
  ion,
  water,
  dummy
};
inline constexpr std::size_t kResidueKinds = 11;

ResidueKind residue_kind(const Molecule& molecule, const Atom& atom);

const char* residue_kind_name(ResidueKind kind);  // "small non-polar"
// Lesk's hues as Okabe and Ito have them, and others for what is no amino acid.
Rgb8 residue_kind_colour(ResidueKind kind);

}  // namespace alphascope
