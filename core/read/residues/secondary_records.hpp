// SPDX-License-Identifier: GPL-3.0-or-later
// Helices and strands that a file states: HELIX and SHEET of PDB, struct_conf and
// struct_sheet_range of mmCIF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/secondary_structure.hpp"
#include "core/read/pdb/pdb_chain_columns.hpp"

namespace alphascope {

struct Molecule;
struct ModelRange;

// A residue as the records name it. The name of its type is not compared with the atoms.
struct EndResidue {
  std::string chain;
  std::int32_t number = 0;
  char insertion_code = ' ';
  bool has_number = false;  // false: the file gives none, or a text that is none
};

struct SecondaryRecord {
  SecondaryStructure kind = SecondaryStructure::coil;
  EndResidue first, last;
  std::size_t line = 0;  // counted from 1
};

// The helix of a class from 1 to 10, as in columns 39-40 of HELIX. Classes other than 3-10, pi and
// polyproline count as alpha.
SecondaryStructure helix_of_class(std::string_view text);

class SecondaryRecords {
 public:
  void add(SecondaryRecord record) { records_.push_back(std::move(record)); }
  // Lines of a PDB file.
  void take_helix(std::string_view line, std::size_t number, PdbChainColumns& chain_columns);
  void take_strand(std::string_view line, std::size_t number, PdbChainColumns& chain_columns);

  // Fills Molecule::stated_secondary, for each model. Notes count the records that name residues
  // which are not there, that end before they begin, or whose ends are not in one chain.
  void state(Molecule& molecule) const;

 private:
  std::vector<SecondaryRecord> records_;
};

}  // namespace alphascope
