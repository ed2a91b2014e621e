// What a file's records say of residues, beside the names of their atoms. Readers collect it;
// decide_residues.hpp judges it once all of the file is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/molecule/molecule.hpp"
#include "core/read/residues/recorded_bonds.hpp"

namespace alphascope {

// As mmCIF's _entity.type has them; a macrolide counts as none.
enum class EntityType : std::uint8_t { none, polymer, non_polymer, branched, water };

// Of the atoms from one on.
struct ResidueRecord {
  NameId entity = 0;          // label_entity_id
  std::uint32_t section = 0;  // how many TER come before
  bool numbered = false;      // it has a label_seq_id
  bool modified = false;      // MODRES names it
  friend bool operator==(const ResidueRecord&, const ResidueRecord&) = default;
};

class ResidueRecords {
 public:
  // What holds for the atoms from `atom` on; call it in the order of the atoms.
  void add(std::size_t atom, const ResidueRecord& record) {
    if (!runs_.empty() && runs_.back().record == record) return;
    if (!runs_.empty() && runs_.back().begin == atom) runs_.pop_back();
    runs_.push_back({atom, record});
    any_numbered_ |= record.numbered;
    any_unnumbered_ |= !record.numbered;
  }

  // Whether some atoms have a label_seq_id and others none: only then it says which are in a
  // sequence. PyMOL and Open Babel number everything.
  bool numbers_tell() const { return any_numbered_ && any_unnumbered_; }

  struct Run {
    std::size_t begin = 0;
    ResidueRecord record;
  };
  const std::vector<Run>& runs() const { return runs_; }

  std::uint32_t ter_count = 0;
  // By label_entity_id, and by label_asym_id for atoms that give none.
  std::unordered_map<NameId, EntityType> entities, entities_of_chains;
  // The residue names that SEQRES gives a chain.
  std::unordered_map<std::string, std::unordered_set<std::string>> sequences;
  RecordedBonds bonds;

 private:
  std::vector<Run> runs_;
  bool any_numbered_ = false, any_unnumbered_ = false;
};

}  // namespace alphascope
