// The tables of mmCIF that describe assemblies, collected row by row while a file is read.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

struct MmcifAssemblyRow {
  std::map<std::string, std::string> values;  // by column
  std::size_t line = 0;                       // of the first of them
};

class MmcifAssemblyTables {
 public:
  // Tags are in lower case and complete: "_pdbx_struct_oper_list.id".
  static bool wants(std::string_view tag);

  // A value without quotes; the first tag of a table that comes again starts its next row.
  void add(std::string_view tag, std::string_view value, std::size_t line);

  // Assemblies and, for those that cannot be understood, a note in the molecule.
  void finish(Molecule& molecule) const;

 private:
  std::map<std::string, std::vector<MmcifAssemblyRow>> tables_;
};

}  // namespace alphascope
