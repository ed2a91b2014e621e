// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes as records for programs (docs/output-files.md), written by command line and
// window.
#pragma once

#include <memory>

#include "core/document/export/record_source.hpp"
#include "core/document/measures/measure_rows.hpp"
#include "core/document/store/answer.hpp"
#include "core/selection/provenance.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// Facts on one complex. No pointer is null.
struct MeasureFacts {
  RecordSource source;
  std::shared_ptr<const EngineAnswer> answer;
  std::shared_ptr<const MeasuredComplex> measured;

  const UnionMeasures& measures() const { return measured->measures(); }
};

// `derivatives` may be non-null for rows of atoms only.
MeasureRows rows_of_measures(const MeasureFacts& facts, const MeasureQuery& query,
                             std::shared_ptr<const UnionDerivatives> derivatives = {},
                             const RunContext& context = {});

// Provenance with the lattice of the computation.
Provenance provenance_of(const MeasureFacts& facts);
CsvRow measure_csv_row(const MeasureFacts& facts, const MeasureRows& rows, const MeasureRow& row,
                       const Provenance& provenance);

}  // namespace alphascope
