// SPDX-License-Identifier: GPL-3.0-or-later
// The evidence or guess that decided whether a residue is polymer, ligand, ion, water or dummy. It
// is decided once, after reading, by core/read/residues/decide_residues.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alphascope {

// In the order in which evidence is considered.
enum class ResidueReason : std::uint8_t {
  none,     // the format knows no residues
  by_hand,  // set by a user
  // Entity table of the file:
  entity_polymer,
  entity_non_polymer,
  entity_branched,
  entity_water,
  // Other records of the file:
  modified_record,  // MODRES
  sequence_record,  // SEQRES
  sequence_number,  // label_seq_id
  bond_record,      // bound to its neighbours in the chain by LINK, CONECT or struct_conn
  place_in_chain,   // stands within its chain, or before its TER
  hetatm,           // HETATM, and no part of a chain
  after_ter,        // HETATM after the TER of its chain
  bound_ligand,  // bound to a residue of a chain by LINK, CONECT or struct_conn, but not within it
  no_sequence_number,  // ATOM without label_seq_id in a file that has them
  // The residue's own atoms:
  chain_bond,    // bound to its neighbours, C to N or O3' to P
  chain_number,  // atoms of a backbone, and neighbours by number
  one_oxygen,
  one_metal,
  virtual_site,
  // Lists of names:
  polymer_name,
  ligand_name,
  water_name,
  ion_name,
  dummy_name,
  // Guesses:
  backbone_names,  // ATOM with N, CA and C, though bound to nothing
  no_polymer,      // ATOM, but of no amino acid or nucleotide and bound in no chain
  no_name
};
inline constexpr std::size_t kResidueReasons = 28;

// The reason for people: "HETATM, and no part of a chain"; empty for `none`.
const char* reason_text(ResidueReason reason);
// The identifier for tables and JSON: "hetatm".
const char* reason_id(ResidueReason reason);

bool is_guess(ResidueReason reason);
// The beginning of the note on residues of a guess: "Taken as polymer by a guess, since they …".
const char* guess_note(ResidueReason guess);

// Returns whether a list of names or a guess decided.
bool is_less_than_evidence(ResidueReason reason);

}  // namespace alphascope
