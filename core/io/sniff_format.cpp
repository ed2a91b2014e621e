#include "core/io/sniff_format.hpp"

#include <algorithm>
#include <array>

#include "core/io/atom_names.hpp"
#include "core/io/decimal.hpp"
#include "core/io/line_reader.hpp"

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

bool is_number(std::string_view text) {
  Decimal value;
  return !text.empty() && parse_decimal(text, value) == DecimalStatus::ok;
}

bool is_cif_start(std::string_view line) {
  return line.size() >= 5 && (line[0] | 0x20) == 'd' && (line[1] | 0x20) == 'a' &&
         (line[2] | 0x20) == 't' && (line[3] | 0x20) == 'a' && line[4] == '_';
}

// "1.0 2.0 3.0 1.5 …", or four numbers behind one to three labels that begin with a name.
bool is_ball_line(std::string_view line) {
  line = line.substr(0, line.find('#'));
  bool numeric[8] = {};
  int fields = 0;
  for (std::string_view f = next_field(line); !f.empty() && fields < 8; f = next_field(line)) {
    numeric[fields++] = is_number(f);
  }
  const auto four_from = [&](int k) {
    return numeric[k] && numeric[k + 1] && numeric[k + 2] && numeric[k + 3];
  };
  return fields >= 4 && (four_from(0) || (fields <= 7 && !numeric[0] && four_from(fields - 4)));
}

std::string extension_without_gz(const std::filesystem::path& path) {
  std::filesystem::path name = path.filename();
  const auto lower = [](std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return text;
  };
  if (lower(name.extension().string()) == ".gz") name.replace_extension();
  return lower(name.extension().string());
}

}  // namespace

FileFormat sniff_format(const std::filesystem::path& path, std::string_view text) {
  const std::string extension = extension_without_gz(path);
  LineReader lines(text);
  std::string_view line;
  bool first = true;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    if (is_pdb_record(line)) return FileFormat::pdb;
    std::string_view data = trimmed(line);
    if (data.empty() || data.front() == '#') continue;
    if (is_cif_start(data)) return FileFormat::mmcif;
    if (is_ball_line(data)) return FileFormat::ball_table;
    // A count alone in the first line; what follows decides.
    if (first && is_number(data)) {
      first = false;
      continue;
    }
    break;
  }
  if (extension == ".pdb" || extension == ".ent") return FileFormat::pdb;
  if (extension == ".cif" || extension == ".mmcif") return FileFormat::mmcif;
  if (extension == ".xyzr") return FileFormat::ball_table;
  return FileFormat::unknown;
}

std::string describe_unknown(std::string_view text) {
  if (text.empty()) return "an empty file";
  if (text.substr(0, 4096).find('\0') != std::string_view::npos) return "a binary file";
  LineReader lines(text);
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view data = trimmed(line);
    if (!data.empty()) return "a text that begins with \"" + shortened(data) + "\"";
  }
  return "a file of blank lines";
}

}  // namespace alphascope
