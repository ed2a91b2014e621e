// SPDX-License-Identifier: GPL-3.0-or-later
// Prints rows under a heading, one at a time, in aligned columns.
#pragma once

#include <string>
#include <vector>

namespace alphascope::cli {

struct TableColumn {
  std::string heading;
  std::size_t width = 0;  // least width; a wider heading counts
  bool left = false;      // left-aligned; numbers are right-aligned
};

class Table {
 public:
  explicit Table(std::vector<TableColumn> columns);
  std::string heading() const;
  std::string line(const std::vector<std::string>& cells) const;  // with a line end

 private:
  std::vector<TableColumn> columns_;
};

// Columns that a text takes on a terminal: its number of UTF-8 characters.
std::size_t shown_width(const std::string& text);
// The greatest shown_width() of the texts.
std::size_t widest(const std::vector<std::string>& texts);

}  // namespace alphascope::cli
