// SPDX-License-Identifier: GPL-3.0-or-later
// The list of formats, and how the format of a file is recognised. A new format needs a source with
// its reader and entry, and a line here.
#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/file_format.hpp"
#include "core/read/lookalike.hpp"
#include "core/text/letter_case.hpp"
#include "core/text_files/line_reader.hpp"

// In the order of texts for people. The fuzzers are made from this list as well.
#define ALPHASCOPE_FORMATS(FORMAT) \
  FORMAT(pdb)                      \
  FORMAT(pdbqt)                    \
  FORMAT(mmcif)                    \
  FORMAT(pqr)                      \
  FORMAT(xyz)                      \
  FORMAT(tinker)                   \
  FORMAT(xyzr)                     \
  FORMAT(charmm)                   \
  FORMAT(gro)                      \
  FORMAT(mol2)

namespace alphascope {

#define ALPHASCOPE_DECLARED(id) FileFormat id##_format();
ALPHASCOPE_FORMATS(ALPHASCOPE_DECLARED)
#undef ALPHASCOPE_DECLARED

namespace {

std::string ending_without_gz(const std::filesystem::path& path) {
  std::filesystem::path name = path.filename();
  if (lower_case(name.extension().string()) == ".gz") name.replace_extension();
  return lower_case(name.extension().string());
}

bool ends_so(const FileFormat& format, std::string_view ending) {
  return std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end();
}

FileSample make_sample(const std::filesystem::path& path, std::string_view text) {
  constexpr int kLinesToLookAt = 2000;
  FileSample sample{.text = text, .ending = ending_without_gz(path), .before = text};
  LineReader lines(text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    const std::string_view data = trimmed(line);
    if (data.empty() || data.front() == '#' || line.starts_with("REMARK")) continue;
    sample.first = line;
    sample.before = text.substr(0, static_cast<std::size_t>(line.data() - text.data()));
    lines.next(sample.second);
    lines.next(sample.third);
    break;
  }
  return sample;
}

std::string joined(std::string_view FileFormat::*part, std::string_view separator) {
  std::string text;
  for (const FileFormat& format : file_formats()) {
    if (!text.empty()) text += separator;
    text += format.*part;
  }
  return text;
}

}  // namespace

const std::vector<FileFormat>& file_formats() {
#define ALPHASCOPE_LISTED(id) id##_format(),
  static const std::vector<FileFormat> formats{ALPHASCOPE_FORMATS(ALPHASCOPE_LISTED)};
  return formats;
}

const FileFormat* format_from_id(std::string_view id) {
  for (const FileFormat& format : file_formats()) {
    if (format.id == id) return &format;
  }
  return nullptr;
}

const FileFormat* recognise_format(const std::filesystem::path& path, std::string_view text) {
  const FileSample sample = make_sample(path, text);
  const bool binary = text.substr(0, 4096).find('\0') != std::string_view::npos;
  const FileFormat* best = nullptr;
  Recognised how_well = Recognised::no;
  for (const FileFormat& format : file_formats()) {
    const Recognised fits = format.recognise(sample);
    if (fits <= how_well) continue;
    if (fits == Recognised::by_ending && (binary || !ends_so(format, sample.ending))) continue;
    how_well = fits;
    best = &format;
  }
  // find_lookalike() can be wrong where a title begins like another format ("solid water"), so a
  // certain format wins.
  return how_well < Recognised::certain && find_lookalike(text).certain ? nullptr : best;
}

bool has_molecule_ending(const std::filesystem::path& path) {
  const std::string ending = ending_without_gz(path);
  return std::any_of(file_formats().begin(), file_formats().end(),
                     [&](const FileFormat& format) { return ends_so(format, ending); });
}

std::string format_ids() {
  return joined(&FileFormat::id, "|");
}

std::string format_names() {
  return joined(&FileFormat::name, ", ");
}

}  // namespace alphascope
