// SPDX-License-Identifier: GPL-3.0-or-later
// Collects helices and strands of mmCIF's tables struct_conf and struct_sheet_range while a file is
// read.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/read/residues/secondary_records.hpp"

namespace alphascope {

class MmcifSecondaryTables {
 public:
  // Tags are complete and in lower case: "_struct_conf.conf_type_id".
  static bool wants(std::string_view tag);

  // Takes a value without quotes, of data block `block`, in a line counted from 1. The next row
  // starts when the row's first tag comes again.
  void add(int block, std::string_view tag, std::string_view value, std::size_t line);

  // Gives the records of a block.
  void finish(int block, SecondaryRecords& records);

 private:
  struct Row {
    std::map<std::string, std::string, std::less<>> values;
    std::size_t line = 0;
  };
  struct Block {
    Row helix, strand;  // the rows being collected
    SecondaryRecords records;
  };
  static void take_helix(Block& block);
  static void take_strand(Block& block);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
