// SPDX-License-Identifier: GPL-3.0-or-later
// REMARK 350 of PDB files, which gives assemblies as BIOMT matrices for lists of chains.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/molecule/molecule.hpp"

namespace alphascope {

class PdbAssemblyRecords {
 public:
  // Takes a line that begins with "REMARK 350".
  void take(std::string_view line, std::size_t line_number);

  // Adds the assemblies to the molecule, and a note when a record cannot be understood.
  void finish(Molecule& molecule);

 private:
  void take_matrix_row(std::string_view text, std::size_t line_number);
  void take_chains(std::string_view list);
  void begin_assemblies(std::string_view ids);
  void share_last();
  void take_all_chains(const Molecule& molecule);
  Assembly& current();

  Assemblies assemblies_;
  SymmetryOperator operator_;
  int rows_ = 0;             // rows of operator_ read so far
  std::size_t sharing_ = 0;  // how many assemblies before the last are equal to it
  bool chains_open_ = false;
  std::size_t bad_line_ = 0;
};

}  // namespace alphascope
