// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a chemical component with coordinates from a CIF file without atom sites. The wwPDB's
// dictionary has such files, and programs that make ligands write them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/read/mmcif/cif_value.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"

namespace alphascope {

class MmcifComponent {
 public:
  // Tags are complete and in lower case: "_chem_comp_atom.atom_id".
  static bool wants(std::string_view tag) { return tag.starts_with(kTable); }

  // The columns of the first table of atoms. Values follow in file order.
  void begin(const std::vector<std::string>& tags) { tags_ = tags; }
  void add(const CifValue& value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }

  // Adds the atoms to an empty molecule, with a note. Takes ideal coordinates where the model's are
  // incomplete. Adds no atoms where both are incomplete. Throws ReadError for a value that is not a
  // number.
  void take(MoleculeBuilder& builder, AtomGuesser& guesser) const;

 private:
  static constexpr std::string_view kTable = "_chem_comp_atom.";
  std::size_t column(std::string_view name) const;  // past the end: no such column
  std::size_t rows() const { return values_.size() / tags_.size(); }
  const CifValue& value(std::size_t row, std::size_t column) const {
    return values_[row * tags_.size() + column];
  }
  std::string_view text(std::size_t row, std::size_t column) const;
  bool is_whole(const std::array<std::size_t, 3>& place) const;

  std::vector<std::string> tags_;
  std::vector<CifValue> values_;
};

}  // namespace alphascope
