// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds that a file states: LINK and CONECT of PDB, struct_conn of mmCIF.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/read/pdb/pdb_chain_columns.hpp"

namespace alphascope {

// An atom as LINK and struct_conn name it.
struct BondedAtom {
  std::string chain, name;
  std::int32_t residue_number = 0;
  char insertion_code = ' ';
};

class RecordedBonds {
 public:
  void add(BondedAtom a, BondedAtom b) { named_.emplace_back(std::move(a), std::move(b)); }
  // Adds a bond between two serial numbers. 0 means no atom.
  void add(std::int32_t a, std::int32_t b) {
    if (a != 0 && b != 0) numbered_.emplace_back(a, b);
  }
  // Lines of a PDB file. Bonds to atoms of another asymmetric unit are left out.
  void take_link(std::string_view line, PdbChainColumns& chain_columns);
  void take_conect(std::string_view line);

  using Named = std::vector<std::pair<BondedAtom, BondedAtom>>;
  using Numbered = std::vector<std::pair<std::int32_t, std::int32_t>>;
  const Named& named() const { return named_; }
  const Numbered& numbered() const { return numbered_; }

 private:
  Named named_;
  Numbered numbered_;
};

}  // namespace alphascope
