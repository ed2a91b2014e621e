// A chemical component with coordinates, in a CIF file without a table of atom sites: of the
// wwPDB's dictionary or of programs that make ligands.
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
  // A tag in lower case and complete: "_chem_comp_atom.atom_id".
  static bool wants(std::string_view tag) { return tag.starts_with(kTable); }

  // Of the first table of atoms; values in the order of the file.
  void begin(const std::vector<std::string>& tags) { tags_ = tags; }
  void add(const CifValue& value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }

  // Adds the atoms to a molecule that has none, and says so. Ideal coordinates are taken where
  // those of the model are not complete; none, where these are not either. Throws ReadError for
  // what is no number.
  void take(MoleculeBuilder& builder, AtomGuesser& guesser) const;

 private:
  static constexpr std::string_view kTable = "_chem_comp_atom.";
  std::size_t column(std::string_view name) const;  // past the end: there is none
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
