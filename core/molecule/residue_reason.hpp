// Why a residue counts as polymer, ligand, ion, water or dummy: the evidence or the guess that
// decided. Decided once, after reading, by core/read/residues/decide_residues.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alphascope {

// In the order in which evidence is asked.
enum class ResidueReason : std::uint8_t {
  none,     // the format knows no residues
  by_hand,  // a user said so
  // What the file's entity table says.
  entity_polymer,
  entity_non_polymer,
  entity_branched,
  entity_water,
  // What other records say.
  modified_record,     // MODRES
  sequence_record,     // SEQRES
  sequence_number,     // label_seq_id
  bond_record,         // LINK, CONECT, struct_conn: to its neighbours in the chain
  place_in_chain,      // stands within its chain, or before its TER
  hetatm,              // HETATM, and no part of a chain
  after_ter,           // the same, after the TER of its chain
  bound_ligand,        // LINK, CONECT, struct_conn: to a residue of a chain, but not within it
  no_sequence_number,  // ATOM without label_seq_id in a file that has them
  // What the residue's own atoms say.
  chain_bond,    // bound to its neighbours, C to N or O3' to P
  chain_number,  // its backbone's atoms, and neighbours by number
  one_oxygen,
  one_metal,
  virtual_site,
  // Lists of names.
  polymer_name,
  ligand_name,
  water_name,
  ion_name,
  dummy_name,
  // Guesses.
  backbone_names,  // ATOM with N, CA and C, though bound to nothing
  no_polymer,      // ATOM, but of no amino acid or nucleotide and bound in no chain
  no_name
};
inline constexpr std::size_t kResidueReasons = 28;

// "HETATM, and no part of a chain"; empty for `none`.
const char* reason_text(ResidueReason reason);
// "hetatm": for tables and JSON.
const char* reason_id(ResidueReason reason);

bool is_guess(ResidueReason reason);
// Of a guess, how the note on its residues begins: "Taken as polymer by a guess, since they …".
const char* guess_note(ResidueReason guess);

// Whether it is a list of names or a guess that decided.
bool is_less_than_evidence(ResidueReason reason);

}  // namespace alphascope
