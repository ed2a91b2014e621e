// Tables as comma-separated values (RFC 4180), for pandas, R and spreadsheets.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

// A row as column names and values; all rows of a table have the same names.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

// All that a double has, for tables that programs read.
std::string all_digits(double number);
// The same; empty for what is no number (NaN, infinite).
std::string finite_digits(double number);

// "15.8843": to a tenth of a microsecond; empty for what is no number.
std::string csv_milliseconds(double milliseconds);

// Spreadsheets compute a cell that begins with =, +, -, @, a tab or a CR and is no number: a name
// in a file could call programs. Such a text gets an apostrophe in front, as do those that begin
// with apostrophes before one of these; plain_cell() takes it off, so that texts that differ stay
// so.
std::string safe_cell(const std::string& text);
std::string plain_cell(const std::string& cell);

// The line with a row's names, and that with its values, each a safe_cell(); ended.
std::string csv_names(const CsvRow& row);
std::string csv_values(const CsvRow& row);

// What stands above a table: each in a line of its own, "# " before it. Behind a comma, a semicolon
// or a tab, where a spreadsheet begins a cell, an apostrophe keeps a formula a text.
std::string csv_comments(const std::vector<std::string>& comments);

// A line with the names, then one line a row.
std::string csv_text(const std::vector<CsvRow>& rows);

// Written whole or not at all. Throws WriteError.
void write_csv(const std::vector<CsvRow>& rows, const std::filesystem::path& path);

}  // namespace alphascope
