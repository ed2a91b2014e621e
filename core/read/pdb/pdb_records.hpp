// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the atom lines of a PDB file: ATOM and HETATM, and lines that nearly are such records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/read/file_format.hpp"

namespace alphascope {

// Columns first..last of a line, counted from 1. Shorter or empty where the line ends early.
inline std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

// True for "HEADER", "REMARK", "ATOM  " and other records that can begin a file.
bool is_pdb_record(std::string_view line);
// True when PDB records come first. PQR files begin with them, too.
bool begins_as_pdb(const FileSample& sample);
// True when the records are of PQR, as a remark or the file name says.
bool begins_as_pqr(const FileSample& sample);

enum class PdbLine : std::uint8_t {
  atom,         // as in the format, or with a serial number of six or seven digits
  nearly_atom,  // read as an atom: behind blanks, in lower case, "ATOMS", "HETATOM"
  like_atom,    // not read: behind "#" or "REMARK", or not in the columns
  other
};

// skip: blanks before the record, which shift all columns right.
struct PdbLineKind {
  PdbLine what = PdbLine::other;
  bool hetero = false;
  std::size_t skip = 0;
};
PdbLineKind kind_of_pdb_line(std::string_view line);

// "END", "TER", "ENDMDL" or "MODEL", in any case and also behind blanks. Empty for other lines.
std::string_view pdb_mark(std::string_view line);

// Finds where atom names begin in column 13 although their element has one letter. "OAB " or "F1  "
// show it for all names of their residue; there "CA  " need not be calcium. "N   ", "C   " or "O
// " of an ATOM record shows it for the whole file.
class PdbNameColumns {
 public:
  explicit PdbNameColumns(std::string_view text);
  bool left_justified(std::string_view residue) const;

 private:
  std::set<std::string, std::less<>> residues_;
  bool all_ = false;
};

// Counts lines of one sort, and keeps the numbers of the first few.
class CountedLines {
 public:
  void add(std::size_t line);
  std::size_t count() const { return count_; }
  std::string text() const;  // "3 (lines 5, 10, 21)"

 private:
  std::size_t count_ = 0;
  std::vector<std::size_t> first_;
};

}  // namespace alphascope
