// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of the table of areas and volumes, for window, command line, CSV, JSON and docs.
#pragma once

#include <span>

namespace alphascope {

template <class Row>
struct Column;
struct MeasureFacts;  // measure_records.hpp
struct MeasureRow;
struct MeasureRows;

// A row of the table. The window has no `facts`: it shows no column of the request.
struct MeasuredRow {
  const MeasureRows& rows;
  const MeasureRow& row;
  const MeasureFacts* facts = nullptr;
};

// In the order of the CSV. The provenance follows there.
std::span<const Column<MeasuredRow>> measure_columns();

}  // namespace alphascope
