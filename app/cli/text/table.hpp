// Rows under a heading, aligned as they come.
#pragma once

#include <string>
#include <vector>

namespace alphascope::cli {

struct TableColumn {
  std::string heading;
  std::size_t width = 0;  // at least; of the heading, if that is wider
  bool left = false;      // aligned; numbers stand right
};

class Table {
 public:
  explicit Table(std::vector<TableColumn> columns);
  std::string heading() const;
  std::string line(const std::vector<std::string>& cells) const;  // ended

 private:
  std::vector<TableColumn> columns_;
};

// Columns that a text takes on a terminal: characters of UTF-8.
std::size_t shown_width(const std::string& text);
// The widest of them.
std::size_t widest(const std::vector<std::string>& texts);

}  // namespace alphascope::cli
