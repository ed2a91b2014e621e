// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the thesis' suite as one table for CSV, JSON and the window's export.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bench/thesis_suite.hpp"
#include "core/document/tables/column.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

struct ThesisTableRow {
  const ThesisReport& report;
  const ThesisRow& row;
};

// The columns of CSV and JSON, without provenance. Times are rounded to a tenth of a microsecond. A
// cell has no value if nothing was measured or the column does not apply.
std::span<const Column<ThesisTableRow>> thesis_columns();

// The cell in CSV, with the shortest text of a number that reads back exactly.
std::string shortest_cell(const CellValue& value);

// One row for each row of the report, all with the same columns, then the provenance.
std::vector<CsvRow> thesis_csv(const ThesisReport& report);

// For example "tuples-cpu", "tuples-cpu, without edge optimisation", "CGAL, one thread".
std::string contestant_text(const ThesisRow& row);
// For example "1.5 Å² (lost at 1.75)", "≥ 3 Å²", "none of those tried".
std::string break_even_text(const BreakEven& found);

}  // namespace alphascope
