// The rows of the thesis' suite as one table for CSV, JSON and the window's export.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/bench/thesis_suite.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// Empty if nothing was measured or the column does not apply.
using ThesisCell = std::variant<std::monostate, std::string, double, std::uint64_t, bool>;
using ThesisTableRow = std::vector<std::pair<std::string, ThesisCell>>;

// One row for each row of the report, all with the same columns (docs/output-files.md). Times are
// rounded to a tenth of a microsecond.
std::vector<ThesisTableRow> thesis_table(const ThesisReport& report);

// Numbers get the shortest text that reads back exactly. Booleans become 1 and 0.
std::vector<CsvRow> to_csv(const std::vector<ThesisTableRow>& table);

// For example "tuples-cpu", "tuples-cpu, without edge optimisation", "CGAL, one thread".
std::string contestant_text(const ThesisRow& row);
// For example "1.5 Å² (lost at 1.75)", "≥ 3 Å²", "none of those tried".
std::string break_even_text(const BreakEven& found);

}  // namespace alphascope
