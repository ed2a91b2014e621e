// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the mmCIF tables that describe assemblies, row by row, while a file is read.
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
  std::size_t line = 0;                       // line of the first value
};

class MmcifAssemblyTables {
 public:
  // Tags are complete and in lower case: "_pdbx_struct_oper_list.id".
  static bool wants(std::string_view tag);

  // Takes a value without quotes. The next row of a table starts when its first tag comes again.
  void add(std::string_view tag, std::string_view value, std::size_t line);

  // Adds the assemblies to the molecule, and a note for those that cannot be understood.
  void finish(Molecule& molecule) const;

 private:
  std::map<std::string, std::vector<MmcifAssemblyRow>> tables_;
};

}  // namespace alphascope
