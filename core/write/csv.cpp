// SPDX-License-Identifier: GPL-3.0-or-later
// Writes tables as CSV and protects cells from spreadsheets.
#include "core/write/csv.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "core/files/atomic_file.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kBeginFormulas = "=+-@\t\r";

bool is_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  return stopped == end && error != std::errc::invalid_argument;
}

// Returns whether the text, after any apostrophes, begins like a formula.
bool begins_formula(const std::string& text) {
  const std::size_t first = text.find_first_not_of('\'');
  return first != text.npos && kBeginFormulas.find(text[first]) != kBeginFormulas.npos &&
         !(first == 0 && is_number(text));
}

// Quotes a value that a reader would split into several fields. Some readers split at semicolons.
std::string field(const std::string& value) {
  const std::string text = safe_cell(value);
  if (text.find_first_of(",;\t\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string safe_cell(const std::string& text) {
  return begins_formula(text) ? "'" + text : text;
}

std::string plain_cell(const std::string& cell) {
  const bool marked = cell.starts_with('\'') && begins_formula(cell);
  return marked ? cell.substr(1) : cell;
}

std::string all_digits(double number) {
  char text[48];
  std::snprintf(text, sizeof text, "%.17g", number == 0 ? 0 : number);
  return text;
}

std::string finite_digits(double number) {
  return std::isfinite(number) ? all_digits(number) : "";
}

std::string csv_milliseconds(double milliseconds) {
  if (!std::isfinite(milliseconds)) return "";
  char text[48];
  std::snprintf(text, sizeof text, "%.4f", milliseconds);
  return text;
}

std::string csv_names(const CsvRow& row) {
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) line += (k ? "," : "") + field(row[k].first);
  return line + "\n";
}

std::string csv_values(const CsvRow& row) {
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) line += (k ? "," : "") + field(row[k].second);
  return line + "\n";
}

std::string csv_comments(const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) {
    text += "# ";
    bool begins = false;  // whether a spreadsheet would begin a cell here
    for (const char c : comment) {
      if (begins && kBeginFormulas.find(c) != kBeginFormulas.npos) text += '\'';
      begins = c == ',' || c == ';' || c == '\t' || (begins && c == ' ');
      text += c;
    }
    text += '\n';
  }
  return text;
}

std::string csv_text(const std::vector<CsvRow>& rows) {
  std::string text;
  if (!rows.empty()) text = csv_names(rows.front());
  for (const CsvRow& row : rows) text += csv_values(row);
  return text;
}

void write_csv(const std::vector<CsvRow>& rows, const std::filesystem::path& path) {
  AtomicFile file(path);
  file.write(csv_text(rows));
  file.commit();
}

}  // namespace alphascope
