// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the mmCIF tables on the types of molecules while a file is read.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/read/residues/residue_records.hpp"

namespace alphascope {

class MmcifEntityTables {
 public:
  // Tags are complete and in lower case: "_entity.type".
  static bool wants(std::string_view tag);

  // Takes a value without quotes, of data block `block`.
  void add(int block, std::string_view tag, std::string_view value);

  // Gives the types of a block's entities to `records`. Entities whose name no atom has are left
  // out.
  void finish(int block, const NameTable& names, ResidueRecords& records) const;

 private:
  struct Row {
    std::map<std::string, std::string> values;
  };
  struct Block {
    std::map<std::string, EntityType> types;            // keys are entities
    std::map<std::string, std::string> entity_of_asym;  // keys are label_asym_id
    std::map<std::string, Row> open;                    // the last row of each table
  };
  static void take(Block& block, std::string_view table, const Row& row);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
