// SPDX-License-Identifier: GPL-3.0-or-later
// Texts and identifiers of the reasons for a residue's kind.
#include "core/molecule/residue_reason.hpp"

namespace alphascope {
namespace {

struct Info {
  const char* id;
  const char* text;
};

const Info& info(ResidueReason reason) {
  static constexpr Info kInfos[kResidueReasons] = {
      {"none", ""},
      {"by_hand", "set by hand"},
      {"entity_polymer", "a polymer in the entity table"},
      {"entity_non_polymer", "non-polymer in the entity table"},
      {"entity_branched", "branched in the entity table"},
      {"entity_water", "water in the entity table"},
      {"modified_record", "MODRES names it"},
      {"sequence_record", "SEQRES lists this residue name for the chain"},
      {"sequence_number", "label_seq_id gives its place in a sequence"},
      {"bond_record", "bound within its chain by LINK, CONECT or struct_conn"},
      {"place_in_chain", "stands within its chain"},
      {"hetatm", "HETATM, and no part of a chain"},
      {"after_ter", "HETATM after the TER of its chain, and bound to none"},
      {"bound_ligand", "covalently bound to a residue, but not within its chain"},
      {"no_sequence_number", "no place in a sequence (label_seq_id)"},
      {"chain_bond", "bound to its neighbours in the chain"},
      {"chain_number", "backbone, and neighbours by number"},
      {"one_oxygen", "one oxygen and at most two hydrogens"},
      {"one_metal", "one atom of a metal"},
      {"virtual_site", "virtual sites, which are no atoms"},
      {"polymer_name", "name of an amino acid, nucleotide or cap"},
      {"ligand_name", "name of a ligand"},
      {"water_name", "name of a water"},
      {"ion_name", "name of an ion"},
      {"dummy_name", "name of dummies"},
      {"backbone_names",
       "guess: ATOM records with backbone atoms, but without bonds to neighbours"},
      {"no_polymer", "guess: ATOM, but no amino acid or nucleotide, and bound in no chain"},
      {"no_name", "guess: ATOM of a residue without a name"}};
  return kInfos[static_cast<std::size_t>(reason)];
}

}  // namespace

const char* reason_text(ResidueReason reason) {
  return info(reason).text;
}

const char* reason_id(ResidueReason reason) {
  return info(reason).id;
}

bool is_guess(ResidueReason reason) {
  return reason >= ResidueReason::backbone_names;
}

const char* guess_note(ResidueReason guess) {
  switch (guess) {
    case ResidueReason::no_polymer:
      return "Taken as ligands by a guess, since they are ATOM records of no amino acid or "
             "nucleotide and bound in no chain";
    case ResidueReason::backbone_names:
      return "Taken as polymer by a guess, since they are ATOM records with the names of a "
             "backbone, though bound to nothing";
    default:
      return "Taken as polymer by a guess, since they have no name";
  }
}

bool is_less_than_evidence(ResidueReason reason) {
  return reason >= ResidueReason::polymer_name;
}

}  // namespace alphascope
