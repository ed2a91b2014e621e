// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the bonds of mmCIF's tables struct_conn and chem_comp_bond while a file is read.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/read/residues/recorded_bonds.hpp"

namespace alphascope {

class MmcifBondTable {
 public:
  // Tags are complete and in lower case: "_struct_conn.conn_type_id".
  static bool wants(std::string_view tag) {
    return tag.starts_with(kTable) || tag.starts_with(kComponents);
  }

  // Takes a value without quotes, of data block `block`. The next row starts when the row's first
  // tag comes again.
  void add(int block, std::string_view tag, std::string_view value);

  // Gives the bonds of a block: covalent, disulphides, those of metals, and those of components.
  void finish(int block, RecordedBonds& bonds);

 private:
  static constexpr std::string_view kTable = "_struct_conn.", kComponents = "_chem_comp_bond.";
  using Row = std::map<std::string, std::string, std::less<>>;
  struct Block {
    Row row, component_row;  // the rows being collected, of each table
    RecordedBonds bonds;
  };
  static void take(Block& block);
  static void take_component(Block& block);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
