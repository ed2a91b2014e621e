// SPDX-License-Identifier: GPL-3.0-or-later
// Prints columns of a table's list, aligned on the terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/cli/text/table.hpp"
#include "core/document/tables/column.hpp"

namespace alphascope::cli {

// A column's place on the terminal.
struct PrintedColumn {
  const char* id;
  std::size_t width = 0;  // least width, as in TableColumn
  bool left = false;
  int decimals = 3;
  const char* none = "-";  // for a cell without a value
};

template <class Row>
class PrintedTable {
 public:
  PrintedTable(std::span<const Column<Row>> columns, std::span<const PrintedColumn> printed)
      : printed_(printed), columns_(chosen(columns, printed)), table_(this->columns()) {}
  // The headings, for a table that has further columns between these.
  std::vector<TableColumn> columns() const {
    std::vector<TableColumn> found;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      found.push_back({columns_[k]->heading(), printed_[k].width, printed_[k].left});
    }
    return found;
  }
  std::string heading() const { return table_.heading(); }
  std::vector<std::string> cells(const Row& row) const {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const PrintedColumn& p = printed_[k];
      texts.push_back(fixed_cell(columns_[k]->value(row), p.decimals, p.none));
    }
    return texts;
  }
  std::string line(const std::vector<std::string>& cells) const { return table_.line(cells); }
  std::string line(const Row& row) const { return line(cells(row)); }

 private:
  static std::vector<const Column<Row>*> chosen(std::span<const Column<Row>> columns,
                                                std::span<const PrintedColumn> printed) {
    std::vector<const Column<Row>*> found;
    for (const PrintedColumn& p : printed) found.push_back(&column_of(columns, p.id));
    return found;
  }

  std::span<const PrintedColumn> printed_;
  std::vector<const Column<Row>*> columns_;
  Table table_;
};

}  // namespace alphascope::cli
