// SPDX-License-Identifier: GPL-3.0-or-later
// What a list of columns says about its columns, without their rows.
#pragma once

#include <string>
#include <vector>

#include "core/document/tables/column.hpp"

namespace alphascope {

struct ColumnInfo {
  std::string id, title, unit, help;
  InFiles files = InFiles::both;
};

// A table of the program, as `alphascope-cli columns` lists it.
struct TableInfo {
  std::string id;    // "cavities"
  std::string text;  // "a row for each cavity"
  std::vector<ColumnInfo> columns;
};

template <class Row>
std::vector<ColumnInfo> infos_of(std::span<const Column<Row>> columns) {
  std::vector<ColumnInfo> infos;
  for (const Column<Row>& column : columns) {
    infos.push_back({column.id, column.title, column.unit, column.help, column.files});
  }
  return infos;
}

// "CSV and JSON", "CSV" or "JSON"; "screen" for columns of window or terminal alone.
inline const char* files_text(InFiles files) {
  switch (files) {
    case InFiles::both:
      return "CSV and JSON";
    case InFiles::csv:
      return "CSV";
    case InFiles::json:
      return "JSON";
    case InFiles::none:
      break;
  }
  return "screen";
}

}  // namespace alphascope
