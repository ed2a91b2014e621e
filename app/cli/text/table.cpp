// SPDX-License-Identifier: GPL-3.0-or-later
// Aligns cells by their width on a terminal.
#include "app/cli/text/table.hpp"

#include <algorithm>

#include "core/run/internal_error.hpp"

namespace alphascope::cli {

std::size_t shown_width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t widest(const std::vector<std::string>& texts) {
  std::size_t width = 0;
  for (const std::string& text : texts) width = std::max(width, shown_width(text));
  return width;
}

Table::Table(std::vector<TableColumn> columns) : columns_(std::move(columns)) {
  for (TableColumn& column : columns_) {
    column.width = std::max(column.width, shown_width(column.heading));
  }
}

std::string Table::heading() const {
  std::vector<std::string> cells;
  for (const TableColumn& column : columns_) cells.push_back(column.heading);
  return line(cells);
}

std::string Table::line(const std::vector<std::string>& cells) const {
  if (cells.size() != columns_.size()) {
    throw InternalError("A row of a table does not have as many cells as the table has columns.");
  }
  std::string text;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const std::size_t width = shown_width(cells[k]);
    const std::string blank(columns_[k].width - std::min(columns_[k].width, width), ' ');
    text += (k ? "  " : "") + (columns_[k].left ? cells[k] + blank : blank + cells[k]);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

}  // namespace alphascope::cli
