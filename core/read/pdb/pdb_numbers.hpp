// SPDX-License-Identifier: GPL-3.0-or-later
// Serial and residue numbers of PDB files with more atoms or residues than the columns can hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/read/pdb/pdb_records.hpp"

namespace alphascope {

bool parse_pdb_integer(std::string_view text, std::int32_t& value);

// Parses a decimal, hybrid-36 ("A0000" follows 99999) or hexadecimal number, which some programs
// write. 0 for a text that is no number.
std::int32_t parse_pdb_number(std::string_view text, std::size_t width);

// Parses the residue numbers of a file in their order. After 9999 VMD continues in hexadecimal with
// 2710.
class PdbResidueNumbers {
 public:
  std::int32_t next(std::string_view text, std::size_t line);
  // Lines with a text that is no number, such as "****".
  const CountedLines& no_numbers() const { return no_numbers_; }

 private:
  std::int32_t last_ = 0;
  bool hexadecimal_ = false;
  CountedLines no_numbers_;
};

}  // namespace alphascope
