// SPDX-License-Identifier: GPL-3.0-or-later
// The bonds between the heavy atoms of amino acids and nucleotides. Hydrogens are not listed; they
// are bonded to the nearest atom.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/molecule/bond.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {

// Places number the atoms of a residue.
struct StructureBond {
  std::uint8_t a = 0, b = 0;
  BondOrder order = BondOrder::one;
};

struct ResidueStructure {
  std::vector<std::string_view> atoms;  // by place
  std::vector<StructureBond> bonds;
};

// The structure of a residue by its name: 20 amino acids, selenocysteine, selenomethionine and
// eight nucleotides, with the names of other programs for them. Null for other residues. Orders are
// those of the Chemical Component Dictionary; rings that it calls aromatic are so here.
const ResidueStructure* residue_structure(std::string_view residue);

// The name of an atom in the structures, for a name in a file: "OP1" for "O1P", "C5'" for "C5*".
// nucleotide: the residue is one, else an amino acid. `residue` is the standard name.
std::string_view structure_name(std::string_view residue, std::string_view atom, bool nucleotide);

// Looks up the places of atoms by the ids of their names.
class ResidueStructures {
 public:
  explicit ResidueStructures(const NameTable& names) : names_(names), of_(names.size()) {}

  static constexpr std::uint8_t kNoPlace = 0xff;
  const ResidueStructure* structure(NameId residue) { return entry(residue).structure; }
  std::uint8_t place(NameId residue, NameId atom);

 private:
  struct Entry {
    bool known = false;
    const ResidueStructure* structure = nullptr;
    std::vector<std::uint8_t> places;  // by NameId; kUnknown where nobody asked
  };
  static constexpr std::uint8_t kUnknown = 0xfe;
  Entry& entry(NameId residue);

  const NameTable& names_;
  std::vector<Entry> of_;  // by NameId
};

}  // namespace alphascope
