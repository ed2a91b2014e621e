// SPDX-License-Identifier: GPL-3.0-or-later
// Bonds that a file states: LINK, SSBOND and CONECT of PDB, struct_conn and chem_comp_bond of
// mmCIF, the list of MOL2.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/molecule/bond.hpp"
#include "core/read/pdb/pdb_chain_columns.hpp"

namespace alphascope {

// An atom as LINK and struct_conn name it.
struct BondedAtom {
  std::string chain, name;
  std::int32_t residue_number = 0;
  char insertion_code = ' ';
};

struct NamedBond {
  BondedAtom a, b;
  BondOrder order = BondOrder::unknown;
  // False for bonds of metals and disulphides, which do not make a chain. LINK does not tell which
  // of its bonds are such.
  bool may_make_chain = true;
};

// Two serial numbers.
struct NumberedBond {
  std::int32_t a = 0, b = 0;
  BondOrder order = BondOrder::unknown;
};

// A bond within each residue of this name, as mmCIF's chem_comp_bond lists it.
struct ComponentBond {
  std::string residue, a, b;  // names of the residue and of two atoms
  BondOrder order = BondOrder::unknown;
};

class RecordedBonds {
 public:
  void add(ComponentBond bond) { of_components_.push_back(std::move(bond)); }
  void add(NamedBond bond) { named_.push_back(std::move(bond)); }
  // 0 means no atom.
  void add(const NumberedBond& bond) {
    if (bond.a != 0 && bond.b != 0) numbered_.push_back(bond);
  }
  // Lines of a PDB file. Bonds to atoms of another asymmetric unit are left out.
  void take_link(std::string_view line, PdbChainColumns& chain_columns);
  void take_disulphide(std::string_view line, PdbChainColumns& chain_columns);
  // An atom that is named twice or three times has a double or triple bond, as many programs write.
  void take_conect(std::string_view line);

  using Named = std::vector<NamedBond>;
  using Numbered = std::vector<NumberedBond>;
  const Named& named() const { return named_; }
  const Numbered& numbered() const { return numbered_; }
  const std::vector<ComponentBond>& of_components() const { return of_components_; }

 private:
  Named named_;
  Numbered numbered_;
  std::vector<ComponentBond> of_components_;
};

}  // namespace alphascope
