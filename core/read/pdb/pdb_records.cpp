// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the lines of PDB files, and the columns of atom names.
#include "core/read/pdb/pdb_records.hpp"

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/decimal.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/letter_case.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kMostBlanks = 16;   // blanks accepted before a record
constexpr std::size_t kLongestMark = 24;  // characters before an atom that was turned into a remark
constexpr std::size_t kLinesListed = 5;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// True when x, y and z are in their columns, with a decimal point each.
bool has_position(std::string_view line) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view field = trimmed(columns(line, 31 + 8 * k, 38 + 8 * k));
    Decimal value;
    if (field.find('.') == field.npos || parse_decimal(field, value) != DecimalStatus::ok) {
      return false;
    }
  }
  return line.size() >= 54;
}

bool is_atom(std::string_view line) {
  if (!line.starts_with("ATOM") || line.size() <= 5) return false;
  // Some programs let a serial number of six digits begin in column 6.
  if (line[4] == ' ') return is_blank(line[5]) || is_digit(line[5]);
  // A serial number of seven digits takes columns 5-11.
  return line.size() > 11 && std::all_of(line.begin() + 4, line.begin() + 11, is_digit);
}

// True when the line begins like ATOM or HETATM in any case, perhaps with more letters.
bool begins_nearly(std::string_view line, bool& hetero) {
  constexpr std::size_t kLetters = 7;
  const std::string word = upper_case(line.substr(0, std::min(line.size(), kLetters)));
  hetero = word.starts_with("HETATM") || word.starts_with("HETATOM");
  return hetero || word.starts_with("ATOM");
}

// True for an atom with all its columns behind "#" or "REMARK".
bool has_atom_inside(std::string_view line) {
  for (std::size_t at = 1; at < std::min(line.size(), kLongestMark); ++at) {
    const std::string_view rest = line.substr(at);
    if ((rest.starts_with("ATOM  ") || rest.starts_with("HETATM")) && has_position(rest)) {
      return true;
    }
  }
  return false;
}

constexpr std::string_view kRecords[] = {
    "HEADER", "TITLE ", "COMPND", "REMARK", "CRYST1", "ATOM  ", "HETATM", "MODEL ", "EXPDTA",
    "SEQRES", "AUTHOR", "KEYWDS", "OBSLTE", "JRNL  ", "SOURCE", "NUMMDL", "SPLIT ", "CAVEAT"};

}  // namespace

bool is_pdb_record(std::string_view line) {
  return std::any_of(std::begin(kRecords), std::end(kRecords),
                     [&](std::string_view record) { return line.starts_with(record); });
}

bool begins_as_pdb(const FileSample& sample) {
  return is_pdb_record(sample.first) || sample.before.find("REMARK") != std::string_view::npos;
}

bool begins_as_pqr(const FileSample& sample) {
  if (!begins_as_pdb(sample)) return false;
  return sample.ending == ".pqr" || sample.before.find("PQR file") != std::string_view::npos;
}

PdbLineKind kind_of_pdb_line(std::string_view line) {
  if (line.starts_with("HETATM")) return {PdbLine::atom, true, 0};
  if (is_atom(line)) return {PdbLine::atom, false, 0};
  if (line.size() < 54) return {};
  std::size_t blanks = 0;
  while (blanks < kMostBlanks && is_blank(line[blanks])) ++blanks;
  bool hetero = false;
  if (!begins_nearly(line.substr(blanks), hetero)) {
    // This search is cheap: most other lines hold no such word.
    return {has_atom_inside(line) ? PdbLine::like_atom : PdbLine::other, false, 0};
  }
  const bool behind_blanks = has_position(line.substr(blanks));
  const bool in_place = blanks > 0 && has_position(line);
  if (behind_blanks == in_place) return {PdbLine::like_atom, hetero, 0};
  return {PdbLine::nearly_atom, hetero, behind_blanks ? blanks : 0};
}

std::string_view pdb_mark(std::string_view line) {
  constexpr std::size_t kLongest = 7;  // "MODEL 1"
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  if (line.size() < 3) return {};
  const std::string word = upper_case(line.substr(0, std::min(line.size(), kLongest)));
  const auto ends = [&](std::size_t at) { return line.size() == at || is_blank(line[at]); };
  if (word.starts_with("ENDMDL")) return "ENDMDL";
  if (word.starts_with("END") && trimmed(line).size() == 3) return "END";
  if (word.starts_with("TER") && ends(3)) return "TER";
  if (word.starts_with("MODEL") && ends(5)) return "MODEL";
  return {};
}

PdbNameColumns::PdbNameColumns(std::string_view text) {
  LineReader lines(text);
  std::string_view line;
  while (!all_ && lines.next(line)) {
    const bool atom = is_atom(line);
    if (!atom && !line.starts_with("HETATM")) continue;
    const std::string_view name = columns(line, 13, 16);
    // No hydrogen in this list: programs that else keep to the columns start them in column 13,
    // too.
    constexpr std::string_view kOneLetter = "CNOFPSBIKVWUY";
    if (name.size() < 4 || name[3] != ' ' || kOneLetter.find(name[0]) == kOneLetter.npos) continue;
    const std::string_view residue = trimmed(columns(line, 18, 20));
    const bool short_name = name[1] == ' ';
    // Potassium K and similar ions are alone in their residues.
    if (short_name && residue == trimmed(name)) continue;
    if (short_name && atom && (name[0] == 'N' || name[0] == 'C' || name[0] == 'O')) all_ = true;
    if (element_from_symbol(trimmed(name.substr(0, 2))) == kUnknownElement || short_name) {
      residues_.emplace(residue);
    }
  }
}

bool PdbNameColumns::left_justified(std::string_view residue) const {
  return all_ || residues_.find(residue) != residues_.end();
}

void CountedLines::add(std::size_t line) {
  ++count_;
  if (first_.size() < kLinesListed) first_.push_back(line);
}

std::string CountedLines::text() const {
  std::string list;
  for (const std::size_t line : first_) list += (list.empty() ? "" : ", ") + std::to_string(line);
  const char* const more = count_ > first_.size() ? " …" : "";
  return grouped(count_) + (count_ == 1 ? " (line " : " (lines ") + list + more + ")";
}

}  // namespace alphascope
