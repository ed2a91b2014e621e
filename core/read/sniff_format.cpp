#include "core/read/sniff_format.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/files/line_reader.hpp"
#include "core/read/decimal.hpp"
#include "core/read/lookalike.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr int kLinesToLookAt = 2000;

constexpr std::array<std::string_view, 18> kPdbRecords = {
    "HEADER", "TITLE ", "COMPND", "REMARK", "CRYST1", "ATOM  ", "HETATM", "MODEL ", "EXPDTA",
    "SEQRES", "AUTHOR", "KEYWDS", "OBSLTE", "JRNL  ", "SOURCE", "NUMMDL", "SPLIT ", "CAVEAT"};

bool is_pdb_record(std::string_view line) {
  return std::any_of(kPdbRecords.begin(), kPdbRecords.end(),
                     [&](std::string_view record) { return line.starts_with(record); });
}

bool has_pdb_record(std::string_view text) {
  LineReader lines(text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    // A serial of six digits may begin in column 6; without the name .pdb that could be PQR.
    if (is_pdb_record(line) || line.starts_with("ATOM ")) return true;
  }
  return false;
}

// "ROOT", "BRANCH  1  7", "TORSDOF 3" and AutoDock's remarks: no other format has them.
bool is_pdbqt_record(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = next_field(rest);
  constexpr std::string_view kWords[] = {"ROOT",      "ENDROOT", "BRANCH",
                                         "ENDBRANCH", "TORSDOF", "BEGIN_RES"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords) ||
         (word == "REMARK" && trimmed(rest).starts_with("VINA RESULT"));
}

// An atom with AutoDock's charge of three digits in columns 71-76 and a type in 78-79.
bool is_pdbqt_atom(std::string_view line) {
  if (line.size() < 78 || line[72] != '.' || line[76] != ' ') return false;
  Decimal charge;
  if (parse_decimal(trimmed(line.substr(68, 8)), charge) != DecimalStatus::ok) return false;
  const char type = line[77];
  return (type >= 'A' && type <= 'Z') || (type >= 'a' && type <= 'z');
}

// Whether a text of PDB records is PDBQT: by a record that only it has, or by its first atoms.
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

bool is_cif_start(std::string_view line) {
  return line.size() >= 5 && (line[0] | 0x20) == 'd' && (line[1] | 0x20) == 'a' &&
         (line[2] | 0x20) == 't' && (line[3] | 0x20) == 'a' && line[4] == '_';
}

// The kinds of the first fields of a line: 'i' integer, 'n' other number, 'w' word.
std::string field_kinds(std::string_view line) {
  std::string kinds;
  for (std::string_view f = next_field(line); !f.empty() && kinds.size() < 8;
       f = next_field(line)) {
    Decimal value;
    if (parse_decimal(f, value) != DecimalStatus::ok) {
      kinds += 'w';
    } else {
      kinds += f.find_first_not_of("0123456789") == std::string_view::npos ? 'i' : 'n';
    }
  }
  return kinds;
}

// Four numbers from field k on.
bool numbers_from(std::string_view kinds, std::size_t k, std::size_t count) {
  if (kinds.size() < k + count) return false;
  return kinds.substr(k, count).find('w') == std::string_view::npos;
}

// "1.0 2.0 3.0 1.5 …", or four numbers behind one to three labels that begin with a name.
bool is_ball_line(std::string_view line) {
  const std::string kinds = field_kinds(line.substr(0, line.find('#')));
  return numbers_from(kinds, 0, 4) || (kinds.size() >= 5 && kinds.size() <= 7 && kinds[0] == 'w' &&
                                       numbers_from(kinds, kinds.size() - 4, 4));
}

// "1 OW x y z 221 2", of which one coordinate may be damaged: its reader says that best.
bool is_tinker_atom(std::string_view kinds) {
  if (kinds.size() < 6 || kinds[0] != 'i' || kinds[1] != 'w' || kinds[5] != 'i') return false;
  return std::count(kinds.begin() + 2, kinds.begin() + 5, 'w') <= 1;
}

std::string extension_without_gz(const std::filesystem::path& path) {
  std::filesystem::path name = path.filename();
  if (lower_case(name.extension().string()) == ".gz") name.replace_extension();
  return lower_case(name.extension().string());
}

// What follows a first line that begins with a count: an XYZ file or a table of balls.
FileFormat sniff_counted(std::string_view first, LineReader lines, std::string_view extension) {
  std::string_view second, third;
  lines.next(second);
  const std::string kinds = field_kinds(second);
  if (is_tinker_atom(kinds)) return FileFormat::tinker_xyz;
  lines.next(third);
  const std::string below = field_kinds(third);
  const bool box = kinds.size() == 6 && numbers_from(kinds, 0, 6);
  if (box && below.size() >= 6 && below[0] == 'i' && below[1] == 'w') return FileFormat::tinker_xyz;
  if (field_kinds(first).size() != 1) return FileFormat::unknown;
  if (extension == ".xyz") return FileFormat::xyz;
  if (below.size() >= 4 && below[0] == 'w' && numbers_from(below, 1, 3)) return FileFormat::xyz;
  if (is_ball_line(second) || (trimmed(second).empty() && is_ball_line(third))) {
    return FileFormat::ball_table;
  }
  return FileFormat::unknown;
}

// Title lines with *, then the number of atoms. Other programs begin their reports with * as well.
FileFormat sniff_card(std::string_view text, std::string_view extension) {
  LineReader lines(text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    const std::string_view data = trimmed(line);
    if (data.empty() || data.front() == '*') continue;
    return field_kinds(data).starts_with('i') ? FileFormat::charmm_card : FileFormat::unknown;
  }
  return extension == ".crd" ? FileFormat::charmm_card : FileFormat::unknown;  // cut off
}

FileFormat sniff_content(std::string_view text, std::string_view extension) {
  LineReader lines(text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    if (line.starts_with("REMARK") && line.find("PQR file") != std::string_view::npos) {
      return FileFormat::pqr;
    }
    if (is_pdb_record(line)) {
      if (extension == ".pqr") return FileFormat::pqr;
      if (is_pdbqt(text)) return FileFormat::pdbqt;
      if (!line.starts_with("REMARK")) return FileFormat::pdb;
      continue;  // a later remark may say that this is PQR
    }
    const std::string_view data = trimmed(line);
    if (data.empty() || data.front() == '#') continue;
    if (is_pdbqt_record(line)) return FileFormat::pdbqt;
    if (is_cif_start(data)) return FileFormat::mmcif;
    if (k == 0 && data.front() == '*') return sniff_card(text, extension);
    if (field_kinds(data).starts_with('i')) {
      const FileFormat counted = sniff_counted(data, lines, extension);
      if (counted != FileFormat::unknown) return counted;
    }
    return is_ball_line(data) ? FileFormat::ball_table : FileFormat::unknown;
  }
  return FileFormat::unknown;
}

constexpr std::pair<std::string_view, FileFormat> kIds[] = {{"pdb", FileFormat::pdb},
                                                            {"mmcif", FileFormat::mmcif},
                                                            {"pqr", FileFormat::pqr},
                                                            {"xyz", FileFormat::xyz},
                                                            {"tinker", FileFormat::tinker_xyz},
                                                            {"xyzr", FileFormat::ball_table},
                                                            {"charmm", FileFormat::charmm_card},
                                                            {"pdbqt", FileFormat::pdbqt}};

}  // namespace

std::optional<FileFormat> format_from_id(std::string_view id) {
  for (const auto& [name, format] : kIds) {
    if (name == id) return format;
  }
  return std::nullopt;
}

std::string_view format_id(FileFormat format) {
  for (const auto& [name, known] : kIds) {
    if (known == format) return name;
  }
  return {};
}

FileFormat sniff_format(const std::filesystem::path& path, std::string_view text) {
  if (look_at(text).certain) return FileFormat::unknown;
  const std::string extension = extension_without_gz(path);
  const FileFormat content = sniff_content(text, extension);
  if (content != FileFormat::unknown) return content;
  if (text.substr(0, 4096).find('\0') != std::string_view::npos) return FileFormat::unknown;
  // Damaged or truncated: the reader of the extension says best what is wrong.
  if ((extension == ".pdb" || extension == ".ent") && has_pdb_record(text)) return FileFormat::pdb;
  if (extension == ".pdbqt" && has_pdb_record(text)) return FileFormat::pdbqt;
  if (extension == ".cif" || extension == ".mmcif") return FileFormat::mmcif;
  if (extension == ".pqr") return FileFormat::pqr;
  if (extension == ".xyz") return FileFormat::xyz;
  if (extension == ".xyzr" || extension == ".crd") return FileFormat::ball_table;
  return FileFormat::unknown;
}

}  // namespace alphascope
