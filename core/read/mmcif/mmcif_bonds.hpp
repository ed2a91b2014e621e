// Bonds of mmCIF's table struct_conn, collected while a file is read.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/read/residues/recorded_bonds.hpp"

namespace alphascope {

class MmcifBondTable {
 public:
  // Tags are in lower case and complete: "_struct_conn.conn_type_id".
  static bool wants(std::string_view tag) { return tag.starts_with(kTable); }

  // A value without quotes, of the data block of that number; the first tag that comes again starts
  // the next row.
  void add(int block, std::string_view tag, std::string_view value);

  // The covalent bonds of a block.
  void finish(int block, RecordedBonds& bonds);

 private:
  static constexpr std::string_view kTable = "_struct_conn.";
  struct Block {
    std::map<std::string, std::string, std::less<>> row;  // the one that is open
    RecordedBonds bonds;
  };
  static void take(Block& block);

  std::map<int, Block> blocks_;
};

}  // namespace alphascope
