// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as comma-separated values (RFC 4180), for pandas, R and spreadsheets.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

// A row as column names and values; all rows of a table have the same names.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

// A number with all digits of a double, for tables that programs read.
std::string all_digits(double number);
// The same; empty for NaN and infinity.
std::string finite_digits(double number);

// Milliseconds to a tenth of a microsecond: "15.8843". Empty for NaN and infinity.
std::string csv_milliseconds(double milliseconds);

// Spreadsheets compute a cell that begins with =, +, -, @, a tab or a CR and is no number. So a
// name in a file could call programs. safe_cell() puts an apostrophe before such a text. It also
// does so if the text has apostrophes before one of these characters. plain_cell() removes the
// apostrophe. So different texts stay different.
std::string safe_cell(const std::string& text);
std::string plain_cell(const std::string& cell);

// A line with a row's names, and a line with its values, each a safe_cell(). Both end with a
// newline.
std::string csv_names(const CsvRow& row);
std::string csv_values(const CsvRow& row);

// Comments above a table: one line each, after "# ". Spreadsheets begin a new cell after a comma,
// semicolon or tab. Where a formula would begin there, an apostrophe before it keeps it a text.
std::string csv_comments(const std::vector<std::string>& comments);

// A line of names, then one line for each row.
std::string csv_text(const std::vector<CsvRow>& rows);

// Writes the whole file or nothing. Throws WriteError.
void write_csv(const std::vector<CsvRow>& rows, const std::filesystem::path& path);

}  // namespace alphascope
