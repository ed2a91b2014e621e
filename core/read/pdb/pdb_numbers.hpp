// Serial and residue numbers of PDB files, which have more atoms and residues than the columns
// hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/read/pdb/pdb_records.hpp"

namespace alphascope {

bool parse_pdb_integer(std::string_view text, std::int32_t& value);

// Decimal, hybrid-36 ("A0000" follows 99999) or, as some programs write, hexadecimal; 0 for what is
// no number.
std::int32_t parse_pdb_number(std::string_view text, std::size_t width);

// The residue numbers of a file in turn. VMD goes on in hexadecimal digits after 9999: with 2710.
class PdbResidueNumbers {
 public:
  std::int32_t next(std::string_view text, std::size_t line);
  // Lines with something else, such as "****".
  const CountedLines& no_numbers() const { return no_numbers_; }

 private:
  std::int32_t last_ = 0;
  bool hexadecimal_ = false;
  CountedLines no_numbers_;
};

}  // namespace alphascope
