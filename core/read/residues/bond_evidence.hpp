// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence of recorded bonds for deciding what residues are (decide_residues.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "core/read/residues/recorded_bonds.hpp"
#include "core/read/residues/residue_table.hpp"

namespace alphascope {

// Finds the residues of a model that recorded bonds tie to residues of chains. Bonds of metals are
// left out, as they do not make a chain.
class BondEvidence {
 public:
  BondEvidence(const Molecule& molecule, const ModelRange& model, const ResidueTable& table,
               const RecordedBonds& bonds);

  // True for bonds to C or O3' of one residue of a chain and to N or P of another.
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
  std::vector<std::uint8_t> sides_;  // per residue; empty where the file has no bonds
};

}  // namespace alphascope
