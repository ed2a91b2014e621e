// Tables as comma-separated values (RFC 4180), for pandas, R and spreadsheets.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace alphascope {

// A row as column names and values; all rows of a table have the same names.
using CsvRow = std::vector<std::pair<std::string, std::string>>;

// "15.8843": to a tenth of a microsecond; empty for what is no number (NaN, infinite).
std::string csv_milliseconds(double milliseconds);

// A line with the names, then one line a row.
std::string csv_text(const std::vector<CsvRow>& rows);

// Written whole or not at all. Throws WriteError.
void write_csv(const std::vector<CsvRow>& rows, const std::filesystem::path& path);

}  // namespace alphascope
