#include "core/io/csv.hpp"

#include <cmath>
#include <cstdio>

#include "core/io/atomic_file.hpp"

namespace alphascope {
namespace {

// Quoted where a reader would take it for more than one field.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string all_digits(double number) {
  char text[48];
  std::snprintf(text, sizeof text, "%.17g", number);
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
  for (const std::string& comment : comments) text += "# " + comment + "\n";
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
