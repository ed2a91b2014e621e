// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of rows of areas and volumes, and their order.
#pragma once

#include <string>

#include "core/document/measures/measure_names.hpp"

namespace alphascope {

// A filter for rows, and their order.
struct MeasureQuery {
  MeasureGrouping per = MeasureGrouping::residue;
  std::string filter = {};        // part of the name, in upper or lower case; empty: all rows
  std::string column = "number";  // to sort by: an id of measure_columns()
  bool descending = false;
  bool derivatives = false;  // with MeasureGrouping::atom only
  friend bool operator==(const MeasureQuery&, const MeasureQuery&) = default;
};

}  // namespace alphascope
