// The columns of the table of areas and volumes, for window, command line, CSV, JSON and docs.
#pragma once

#include <span>

#include "core/document/measures/measure_rows.hpp"
#include "core/document/tables/column.hpp"

namespace alphascope {

struct MeasureFacts;  // measure_records.hpp

// A row of the table. The window has no `facts`: it shows no column of the request.
struct MeasuredRow {
  const MeasureRows& rows;
  const MeasureRow& row;
  const MeasureFacts* facts = nullptr;
};

// In the order of the CSV. The provenance follows there.
std::span<const Column<MeasuredRow>> measure_columns();

}  // namespace alphascope
