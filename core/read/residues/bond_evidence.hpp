// What recorded bonds tell of residues: for deciding what they are (decide_residues.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "core/read/residues/recorded_bonds.hpp"
#include "core/read/residues/residue_table.hpp"

namespace alphascope {

// Which residues of a model such bonds tie to residues that chains are made of. Those of metals are
// left out: they are no bonds of a chain.
class BondEvidence {
 public:
  BondEvidence(const Molecule& molecule, const ModelRange& model, const ResidueTable& table,
               const RecordedBonds& bonds);

  // To the C or O3' of one and to the N or P of another.
  bool is_within_chain(std::uint32_t residue) const { return sides(residue) == kAll; }
  bool is_bound_to_chain(std::uint32_t residue) const { return sides(residue) != 0; }

 private:
  static constexpr std::uint8_t kBound = 1, kBehind = 2, kBefore = 4, kAll = 7;
  std::uint8_t sides(std::uint32_t residue) const {
    return sides_.empty() ? std::uint8_t{0} : sides_[residue];
  }
  void note_named(const ModelRange& model, const RecordedBonds::Named& bonds);
  void note_numbered(const ModelRange& model, const RecordedBonds::Numbered& bonds);
  void note(std::uint32_t atom, std::uint32_t partner);
  std::uint32_t residue_of(std::uint32_t atom) const;

  const Molecule& molecule_;
  const ResidueTable& table_;
  std::vector<std::uint8_t> sides_;  // of each residue; empty where the file has no bonds
};

}  // namespace alphascope
