// SPDX-License-Identifier: GPL-3.0-or-later
// Writes cells for CSV, the window and the terminal. Columns are in column.hpp.
#include "core/document/tables/cell_value.hpp"

#include <cstdio>

#include "core/chart/readable_number.hpp"
#include "core/text/fixed_digits.hpp"
#include "core/text/grouped_number.hpp"
#include "core/write/csv.hpp"

namespace alphascope {
namespace {

struct ToCsv {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(bool yes) const { return yes ? "1" : "0"; }
  std::string operator()(std::uint64_t number) const { return std::to_string(number); }
  std::string operator()(double number) const { return finite_digits(number); }
  std::string operator()(const std::string& text) const { return text; }
};

struct ToReadable {
  std::string operator()(std::monostate) const { return "…"; }
  std::string operator()(bool yes) const { return yes ? "yes" : "no"; }
  std::string operator()(std::uint64_t number) const { return grouped(number); }
  std::string operator()(double number) const { return measure_text(number); }
  std::string operator()(const std::string& text) const { return text; }
};

struct ToFixed {
  int decimals;
  const char* none;
  std::string operator()(std::monostate) const { return none; }
  std::string operator()(bool yes) const { return yes ? "*" : ""; }
  std::string operator()(std::uint64_t number) const { return std::to_string(number); }
  std::string operator()(double number) const { return fixed_digits(number, decimals); }
  std::string operator()(const std::string& text) const { return text; }
};

}  // namespace

std::string csv_cell(const CellValue& value) {
  return std::visit(ToCsv{}, value);
}

std::string readable_cell(const CellValue& value) {
  return std::visit(ToReadable{}, value);
}

std::string fixed_cell(const CellValue& value, int decimals, const char* none) {
  return std::visit(ToFixed{decimals, none}, value);
}

std::string measure_text(double value) {
  char text[400];  // the largest double has 309 digits
  std::snprintf(text, sizeof text, "%.2f", value);
  return separated_number(text);
}

}  // namespace alphascope
