// SPDX-License-Identifier: GPL-3.0-or-later
// The fault of a selection expression.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "core/text/printable.hpp"

namespace alphascope {

// what() is a complete, printable sentence: "column 7: expected … after \"chain\"".
class SelectionError : public std::invalid_argument {
 public:
  SelectionError(std::size_t column, const std::string& reason)
      : std::invalid_argument("column " + std::to_string(column) + ": " + printable(reason)),
        column_(column) {}
  std::size_t column() const { return column_; }  // in the expression, counted from 1

 private:
  std::size_t column_;
};

}  // namespace alphascope
