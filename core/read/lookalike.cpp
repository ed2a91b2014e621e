// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of files that are not coordinates, and their remedies.
#include "core/read/lookalike.hpp"
#include "core/text/printable.hpp"

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/decimal.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 4096;  // bytes searched

struct Mark {
  std::size_t at;  // offset in bytes
  std::string_view bytes;
  std::string_view what, remedy;
};

constexpr std::string_view kUnpack = "Unpack it first; this program unpacks gzip only";
constexpr std::string_view kFetchText = "Fetch the entry as mmCIF or PDB";
constexpr std::string_view kConvert =
    "Convert it to PDB, mmCIF or XYZ, for example with Open Babel";
constexpr std::string_view kNoAtoms = "Open the coordinates that belong to it";

constexpr Mark kMarks[] = {
    {0, "BZh", "data packed with bzip2", kUnpack},
    {0,
     "\xfd"
     "7zXZ\0"sv,
     "data packed with xz", kUnpack},
    {0, "\x28\xb5\x2f\xfd", "data packed with zstd", kUnpack},
    {0, "\x1f\x9d", "data packed with compress (.Z)", kUnpack},
    {0, "PK\3\4", "a zip archive", "Unpack it and open the coordinate file inside"},
    {0, "7z\xbc\xaf", "a 7-Zip archive", "Unpack it and open the coordinate file inside"},
    {257, "ustar", "a tar archive", "Unpack it and open the coordinate file inside"},
    {0, "%PDF-", "a PDF document", kFetchText},
    {0, "\x89PNG", "a picture", kFetchText},
    {0, "\xff\xd8\xff", "a picture", kFetchText},
    {0, "\xff\xfe", "a text in UTF-16", "Save it as plain text (UTF-8)"},
    {0, "\xfe\xff", "a text in UTF-16", "Save it as plain text (UTF-8)"},
    {0, "PSF", "a CHARMM or X-PLOR topology (PSF), which has no coordinates", kNoAtoms},
    {0, "%VERSION", "an AMBER topology, which has no coordinates", kNoAtoms},
    {4, "CORD", "a DCD trajectory", "Save the frames that you need as PDB or XYZ"},
    {0, "\0\0\7\xcb"sv, "a GROMACS trajectory (XTC)", "Save the frames that you need as PDB"},
    {0, "\0\0\7\xc9"sv, "a GROMACS trajectory (TRR)", "Save the frames that you need as PDB"},
    {0, "CDF", "NetCDF, perhaps an AMBER trajectory", "Save the frames that you need as PDB"},
    {0, "\x89HDF", "HDF5, perhaps a trajectory", "Save the frames that you need as PDB"},
    {0, "MTZ ", "reflections (MTZ)", kNoAtoms},
    {208, "MAP ", "a density map", kNoAtoms},
    {0, "solid ", "a surface mesh (STL)", kNoAtoms},
    {0, "ply\n", "a surface mesh (PLY)", kNoAtoms},
    {0, "OFF\n", "a surface mesh (OFF)", kNoAtoms},
    {0, "# vtk DataFile", "VTK data", kNoAtoms},
};

bool starts_with_any_case(std::string_view text, std::string_view lower) {
  return text.size() >= lower.size() &&
         std::equal(lower.begin(), lower.end(), text.begin(),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + 32 : b); });
}

bool is_number(std::string_view text) {
  Decimal value;
  return parse_decimal(trimmed(text), value) == DecimalStatus::ok;
}

// The separator of a line such as "1.0, 2.0, 3.0, 1.5"; 0: none.
char separator_of_numbers(std::string_view line) {
  for (const char separator : {',', ';'}) {
    std::size_t count = 0;
    std::string_view rest = line;
    bool good = true;
    while (good && !rest.empty()) {
      const std::size_t end = std::min(rest.find(separator), rest.size());
      good = is_number(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      ++count;
    }
    if (good && count >= 3) return separator;
  }
  return 0;
}

// Recognises formats by their first lines.
Lookalike look_at_lines(std::string_view text) {
  LineReader lines(text);
  std::string_view line[4];
  for (std::string_view& l : line) {
    if (!lines.next(l)) break;
  }
  if (line[3].find("V2000") != line[3].npos || line[3].find("V3000") != line[3].npos) {
    return {"an MDL molfile or SDF", std::string(kConvert), true};
  }
  return {};
}

}  // namespace

Lookalike find_lookalike(std::string_view text) {
  const std::string_view head = text.substr(0, kHead);
  if (head.empty()) return {"an empty file", "", false};
  const bool binary = head.find('\0') != head.npos;
  for (const Mark& mark : kMarks) {
    // In plain text such letters can stand inside a title, so they mean nothing there.
    if (mark.at > 0 && !binary) continue;
    if (head.size() > mark.at && head.substr(mark.at).starts_with(mark.bytes)) {
      return {std::string(mark.what), std::string(mark.remedy), true};
    }
  }
  const bool message_pack = (static_cast<unsigned char>(head[0]) & 0xE0) == 0x80;
  if (message_pack && head.find("dataBlocks") != head.npos) {
    return {"BinaryCIF", std::string(kFetchText), true};
  }
  if (message_pack && head.find("mmtfVersion") != head.npos) {
    return {"MMTF", std::string(kFetchText), true};
  }
  if (binary) return {"a binary file", "", false};
  Lookalike known = look_at_lines(text);
  if (known.certain) return known;

  LineReader lines(text);
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view data = trimmed(line);
    if (data.empty()) continue;
    if (starts_with_any_case(data, "<!doctype html") || starts_with_any_case(data, "<html")) {
      return {"a web page, perhaps the error message of a server",
              "Look at it in a browser, then download the coordinate file itself", true};
    }
    if (data.front() == '<') return {"XML", std::string(kFetchText), true};
    if (data.front() == '{') return {"JSON", "", true};
    if (data.front() == '>') {
      return {"a sequence (FASTA), which has no coordinates", std::string(kNoAtoms), true};
    }
    if (const char separator = separator_of_numbers(data)) {
      return {std::string("a table of numbers with \"") + separator + "\" between them",
              "Write blanks between them: lines \"x y z r\" are XYZR", true};
    }
    return {"a text that begins with \"" + shortened(data) + "\"", "", false};
  }
  return {"a file of blank lines", "", false};
}

}  // namespace alphascope
