// SPDX-License-Identifier: GPL-3.0-or-later
// Records of a file about its residues, beside the names of atoms. Readers collect it, and
// decide_residues.hpp uses it once the whole file is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/read/residues/recorded_bonds.hpp"
#include "core/read/residues/secondary_records.hpp"

namespace alphascope {

// The values of mmCIF's _entity.type. A macrolide counts as none.
enum class EntityType : std::uint8_t { none, polymer, non_polymer, branched, water };

// The records that hold from one atom on.
struct ResidueRecord {
  NameId entity = 0;          // label_entity_id
  std::uint32_t section = 0;  // how many TER records come before
  bool numbered = false;      // the atoms have a label_seq_id
  bool modified = false;      // a MODRES record names the residue
  friend bool operator==(const ResidueRecord&, const ResidueRecord&) = default;
};

class ResidueRecords {
 public:
  // Sets the records for the atoms from `atom` on. Call it in the order of the atoms.
  void add(std::size_t atom, const ResidueRecord& record) {
    if (!runs_.empty() && runs_.back().record == record) return;
    if (!runs_.empty() && runs_.back().begin == atom) runs_.pop_back();
    runs_.push_back({atom, record});
    any_numbered_ |= record.numbered;
    any_unnumbered_ |= !record.numbered;
  }

  // True when some atoms have a label_seq_id and others have none. Only then it shows which are in
  // a sequence, because PyMOL and Open Babel number all atoms.
  bool only_some_are_numbered() const { return any_numbered_ && any_unnumbered_; }

  struct Run {
    std::size_t begin = 0;
    ResidueRecord record;
  };
  const std::vector<Run>& runs() const { return runs_; }

  std::uint32_t ter_count = 0;
  // Keys are label_entity_id, and label_asym_id for atoms without an entity.
  std::unordered_map<NameId, EntityType> entities, entities_of_chains;
  // Residue names in the SEQRES records of each chain.
  std::unordered_map<std::string, std::unordered_set<std::string>> sequences;
  RecordedBonds bonds;
  SecondaryRecords secondary;

 private:
  std::vector<Run> runs_;
  bool any_numbered_ = false, any_unnumbered_ = false;
};

}  // namespace alphascope
