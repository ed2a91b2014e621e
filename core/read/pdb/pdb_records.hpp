// Which lines of a PDB file are atoms: ATOM and HETATM, and lines that are nearly such records.
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

// Columns first..last of a line (from 1); shorter or empty where the line ends early.
inline std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

// "HEADER", "REMARK", "ATOM  " and others that a file may begin with.
bool is_pdb_record(std::string_view line);
// Records stand above all else; PQR files have them, too.
bool begins_as_pdb(const FileSample& sample);
// They are records of PQR, as a remark or the name says.
bool begins_as_pqr(const FileSample& sample);

enum class PdbLine : std::uint8_t {
  atom,         // as the format has it, or with a serial number of six or seven digits
  nearly_atom,  // read as one: behind blanks, in lower case, "ATOMS", "HETATOM"
  like_atom,    // not read: behind "#" or "REMARK", or not in the columns
  other
};

// skip: blanks before the record, which push all columns right.
struct PdbLineKind {
  PdbLine what = PdbLine::other;
  bool hetero = false;
  std::size_t skip = 0;
};
PdbLineKind kind_of_pdb_line(std::string_view line);

// "END", "TER", "ENDMDL" and "MODEL" in either case, also behind blanks; empty for anything else.
std::string_view pdb_mark(std::string_view line);

// Where names of atoms begin in column 13 although their element has one letter. "OAB " and "F1  "
// of a residue show that all its names do, and then "CA  " need not be calcium; "N   " and "C   "
// of ATOM records show it for the whole file.
class PdbNameColumns {
 public:
  explicit PdbNameColumns(std::string_view text);
  bool left_justified(std::string_view residue) const;

 private:
  std::set<std::string, std::less<>> residues_;
  bool all_ = false;
};

// How many lines of one sort there were, and the numbers of the first.
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
