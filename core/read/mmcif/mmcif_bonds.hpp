// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the bonds of mmCIF's table struct_conn while a file is read.
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
  static bool wants(std::string_view tag) { return tag.starts_with(kTable); }

  // Takes a value without quotes, of data block `block`. The next row starts when the row's first
  // tag comes again.
  void add(int block, std::string_view tag, std::string_view value);

  // Gives the bonds of a block: covalent, disulphides, and those of metals.
  void finish(int block, RecordedBonds& bonds);

 private:
  static constexpr std::string_view kTable = "_struct_conn.";
  struct Block {
    std::map<std::string, std::string, std::less<>> row;  // the row being collected
    RecordedBonds bonds;
  };
  static void take(Block& block);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
