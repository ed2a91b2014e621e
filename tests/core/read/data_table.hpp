// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the table in the README of the data folder: a row for each file.
#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/core/files/temporary_file.hpp"

namespace alphascope {

struct DataRow {
  std::string file, format;
  bool molecule = false;                          // else tables or text
  std::size_t atoms = 0, hetero = 0, models = 0;  // for molecules
};

inline std::vector<DataRow> data_table() {
  constexpr const char* kFormats[] = {"PDB", "mmCIF", "CIF", "XYZ", "CRD", "PQR", "CHARMM"};
  std::ifstream readme(test_data("README.md"));
  std::vector<DataRow> rows;
  std::string line;
  while (std::getline(readme, line)) {
    std::vector<std::string> cells;
    for (std::size_t at = line.find('|'); at != std::string::npos;) {
      const std::size_t next = line.find('|', at + 1);
      if (next == std::string::npos) break;
      const std::string cell = line.substr(at + 1, next - at - 1);
      const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
      at = next;
    }
    if (cells.size() < 7 || cells[0].find('/') == std::string::npos) continue;
    DataRow row;
    row.file = cells[0];
    row.format = cells[2];
    row.molecule = std::any_of(std::begin(kFormats), std::end(kFormats),
                               [&](const char* start) { return row.format.starts_with(start); });
    if (row.molecule) {
      row.atoms = std::stoul(cells[3]);
      row.hetero = std::stoul(cells[4]);
      row.models = std::stoul(cells[5]);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace alphascope
