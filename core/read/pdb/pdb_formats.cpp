// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of PDB and PDBQT in the list of formats, with their recognition.
#include <algorithm>
#include <iterator>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/decimal.hpp"
#include "core/read/pdb/pdb_reader.hpp"
#include "core/read/pdb/pdb_records.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr int kLinesToLookAt = 2000;

bool has_pdb_record(std::string_view text) {
  LineReader lines(text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    // A serial of six digits may begin in column 6. A text without the ending .pdb could then be
    // PQR.
    if (is_pdb_record(line) || line.starts_with("ATOM ")) return true;
  }
  return false;
}

// True for "ROOT", "BRANCH  1  7", "TORSDOF 3" and AutoDock's remarks, which no other format has.
bool is_pdbqt_record(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = next_field(rest);
  constexpr std::string_view kWords[] = {"ROOT",      "ENDROOT", "BRANCH",
                                         "ENDBRANCH", "TORSDOF", "BEGIN_RES"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords) ||
         (word == "REMARK" && trimmed(rest).starts_with("VINA RESULT"));
}

// True for an atom with AutoDock's charge (three decimals, columns 71-76) and a type in columns
// 78-79.
bool is_pdbqt_atom(std::string_view line) {
  if (line.size() < 78 || line[72] != '.' || line[76] != ' ') return false;
  Decimal charge;
  if (parse_decimal(trimmed(line.substr(68, 8)), charge) != DecimalStatus::ok) return false;
  const char type = line[77];
  return (type >= 'A' && type <= 'Z') || (type >= 'a' && type <= 'z');
}

// True when a text of PDB records is PDBQT, by a record of PDBQT alone or by its first atoms.
bool is_pdbqt(std::string_view text) {
  constexpr int kAtomsToLookAt = 20;
  LineReader lines(text);
  std::string_view line;
  int atoms = 0;
  for (int k = 0; k < kLinesToLookAt && atoms < kAtomsToLookAt && lines.next(line); ++k) {
    if (is_pdbqt_record(line)) return true;
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    if (!is_pdbqt_atom(line)) return false;
    ++atoms;
  }
  return atoms > 0;
}

Recognised recognise_pdb(const FileSample& sample) {
  if (is_pdb_record(sample.first)) return Recognised::likely;
  return has_pdb_record(sample.text) ? Recognised::by_ending : Recognised::no;
}

Recognised recognise_pdbqt(const FileSample& sample) {
  if (is_pdbqt_record(sample.first)) return Recognised::certain;
  if (begins_as_pdb(sample) && !begins_as_pqr(sample) && is_pdbqt(sample.text)) {
    return Recognised::certain;
  }
  return has_pdb_record(sample.text) ? Recognised::by_ending : Recognised::no;
}

}  // namespace

FileFormat pdb_format() {
  return {"pdb", "PDB", {".pdb", ".ent"}, recognise_pdb, read_pdb, true};
}

FileFormat pdbqt_format() {
  return {"pdbqt", "PDBQT", {".pdbqt"}, recognise_pdbqt, read_pdbqt, true};
}

}  // namespace alphascope
