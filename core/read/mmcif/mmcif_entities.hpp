// The tables of mmCIF that say of what type the molecules of a file are, collected while it is
// read.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/read/residues/residue_records.hpp"

namespace alphascope {

class MmcifEntityTables {
 public:
  // Tags are in lower case and complete: "_entity.type".
  static bool wants(std::string_view tag);

  // A value without quotes, of the data block of that number.
  void add(int block, std::string_view tag, std::string_view value);

  // The types of a block's entities, for the names that the molecule has.
  void finish(int block, const NameTable& names, ResidueRecords& records) const;

 private:
  struct Row {
    std::map<std::string, std::string> values;
  };
  struct Block {
    std::map<std::string, EntityType> types;            // by entity
    std::map<std::string, std::string> entity_of_asym;  // by label_asym_id
    std::map<std::string, Row> open;                    // the last row of each table
  };
  static void take(Block& block, std::string_view table, const Row& row);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
