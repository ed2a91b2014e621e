// SPDX-License-Identifier: GPL-3.0-or-later
// The value of a table's cell at full precision, and its text in files and for people.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace alphascope {

// std::monostate: there is no value, or it is not known yet. A cell without a value is less than
// all others of its column.
using CellValue = std::variant<std::monostate, bool, std::uint64_t, double, std::string>;

// The cell in CSV: 1 or 0, all digits of a number, or the text. Empty without a finite value.
std::string csv_cell(const CellValue& value);

// The cell in the window: "12,345.67", "1,024", "yes" or "no". "…" without a value.
std::string readable_cell(const CellValue& value);
// The cell on a terminal: "12345.678", "1024". True is "*", false is empty; `none` without a value.
std::string fixed_cell(const CellValue& value, int decimals, const char* none);

// Two decimals, with commas between thousands: "12,345.67".
std::string measure_text(double value);

}  // namespace alphascope
