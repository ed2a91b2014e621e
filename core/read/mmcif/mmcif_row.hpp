// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a row of an mmCIF category, by the names of its columns.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace alphascope {

using MmcifRow = std::map<std::string, std::string, std::less<>>;

// Empty if the row has no such column.
inline std::string value(const MmcifRow& row, const std::string& column) {
  const auto found = row.find(column);
  return found == row.end() ? std::string() : found->second;
}

// The value of the first column, or of the second where that is empty.
inline std::string value(const MmcifRow& row, const std::string& first, const std::string& second) {
  const std::string text = value(row, first);
  return text.empty() ? value(row, second) : text;
}

}  // namespace alphascope
