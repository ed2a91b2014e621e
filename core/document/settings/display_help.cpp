// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the table of the settings of the display.
#include "core/document/settings/display_help.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/document/settings/display_fields.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

using Row = std::array<std::string, 6>;

std::string values_text(const DisplayField& field) {
  if (is_switch(field)) return "on, off";
  if (is_paint(field)) return "colours";
  return range_text(field) + (field.rule.unit[0] == '\0' ? "" : std::string(" ") + field.rule.unit);
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  for (const DisplayField& field : display_fields()) {
    const std::string option = field.option.name;
    rows.push_back({field.title, values_text(field), value_text(field, DisplaySettings()),
                    field.command, option.empty() ? "-" : option, field.key});
  }
  for (const BesideKind& kind : kBesideKinds) {
    rows.push_back({std::string(kind.title) + " beside the body", "on, off",
                    AtomsBesideBody().*kind.member ? "on" : "off", command_of(kind), "--beside",
                    std::string("beside.") + kind.id});
  }
  return rows;
}

}  // namespace

std::string display_help() {
  const std::vector<Row> all = rows();
  std::array<std::size_t, 6> widths{};
  for (const Row& row : all) {
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], character_count(row[c]));
  }
  std::string text =
      "Settings of the display: title, values, default, command, option, key in session files:\n";
  for (const Row& row : all) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += "  " + row[c];
      if (c + 1 < row.size()) line.append(widths[c] - character_count(row[c]), ' ');
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace alphascope
