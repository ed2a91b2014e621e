// SPDX-License-Identifier: GPL-3.0-or-later
// Removes quotes from CIF values, and reads coordinates.
#include "core/read/mmcif/cif_value.hpp"
#include "core/text/printable.hpp"

#include <string>

#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {

std::string_view plain_cif(std::string_view raw) {
  if (raw.size() == 1 && (raw[0] == '?' || raw[0] == '.')) return {};
  if (raw.size() >= 2 && (raw[0] == '"' || raw[0] == '\'')) return raw.substr(1, raw.size() - 2);
  if (raw.size() >= 2 && raw[0] == ';') {
    raw = raw.substr(1, raw.size() - 2);
    while (!raw.empty() && (raw.back() == '\n' || is_blank(raw.back()))) raw.remove_suffix(1);
  }
  return raw;
}

Decimal cif_coordinate(const std::filesystem::path& file, const CifValue& value, char axis) {
  std::string_view text = plain_cif(value.raw);
  const std::string name = std::string("Cartn_") + axis;
  if (text.empty()) {
    throw ReadError(file, value.line, name + " has no value (" + shortened(value.raw) + ")",
                    "Every atom needs three coordinates; remove this atom or complete it");
  }
  text = text.substr(0, text.find('('));
  Decimal result;
  const DecimalStatus status = parse_decimal(text, result);
  if (status == DecimalStatus::ok) return result;
  throw ReadError(
      file, value.line, "expected a number for " + name + ", found \"" + shortened(text) + "\"",
      remedy_of_number(status, "The file is damaged, or a value before this one is missing"));
}

}  // namespace alphascope
