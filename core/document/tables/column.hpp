// SPDX-License-Identifier: GPL-3.0-or-later
// A column of a table, written once: for CSV, JSON, the window, the terminal and the docs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/document/tables/cell_value.hpp"
#include "core/run/internal_error.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// The files that have a column. Window and terminal choose their columns by id.
enum class InFiles : std::uint8_t { none = 0, csv = 1, json = 2, both = 3 };

inline bool is_in(InFiles files, InFiles file) {
  return (static_cast<unsigned>(files) & static_cast<unsigned>(file)) != 0;
}

// `Row` has all that a cell depends on. No function keeps the row.
template <class Row>
struct Column {
  const char* id;          // name in CSV and key in JSON, with the unit: "depth_angstrom"
  const char* title = "";  // heading without the unit
  const char* unit = "";   // "Å³"
  const char* help = "";   // sentences on the meaning
  CellValue (*value)(const Row&) = nullptr;
  std::string (*text)(const Row&) = nullptr;  // of the window alone; null: readable_cell(value)
  bool (*shown_if)(const Row&) = nullptr;     // null: always. Equal for all rows of a table.
  InFiles files = InFiles::both;

  std::string heading() const { return *unit == '\0' ? title : std::string(title) + " " + unit; }
  std::string shown_text(const Row& row) const {
    return text ? text(row) : readable_cell(value(row));
  }
  bool is_shown(const Row& row, InFiles file) const {
    return is_in(files, file) && (!shown_if || shown_if(row));
  }
};

// Throws InternalError if there is no such column.
template <class Row>
const Column<Row>& column_of(std::span<const Column<Row>> columns, std::string_view id) {
  const auto at = std::find_if(columns.begin(), columns.end(),
                               [&](const Column<Row>& column) { return column.id == id; });
  if (at == columns.end()) throw InternalError("There is no column " + std::string(id) + ".");
  return *at;
}

// The cells of a row in CSV. Columns that no list has, such as provenance, may follow.
template <class Row>
CsvRow csv_row_of(std::span<const Column<Row>> columns, const Row& row) {
  CsvRow cells;
  for (const Column<Row>& column : columns) {
    if (!column.is_shown(row, InFiles::csv)) continue;
    cells.emplace_back(column.id, csv_cell(column.value(row)));
  }
  return cells;
}

// The line of names of a table that may have no row. The columns are those that every row has.
template <class Row>
std::string csv_heading(std::span<const Column<Row>> columns) {
  CsvRow names;
  for (const Column<Row>& column : columns) {
    if (is_in(column.files, InFiles::csv) && !column.shown_if) names.emplace_back(column.id, "");
  }
  return csv_names(names);
}

}  // namespace alphascope
