// Areas and volumes as programs read them (docs/output-files.md): what the command line and the
// window write of them.
#pragma once

#include <memory>

#include "core/document/export/record_source.hpp"
#include "core/document/measures/measure_rows.hpp"
#include "core/document/store/answer.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// Of one complex. Nothing is null.
struct MeasureFacts {
  RecordSource source;
  std::shared_ptr<const EngineAnswer> answer;
  std::shared_ptr<const MeasuredComplex> measured;

  const UnionMeasures& measures() const { return measured->measures(); }
};

// `derivatives`: null unless asked for, and of atoms only.
MeasureRows rows_of_measures(const MeasureFacts& facts, const MeasureQuery& query,
                             std::shared_ptr<const UnionDerivatives> derivatives = {},
                             const RunContext& context = {});

// With the lattice that was computed on.
Provenance provenance_of(const MeasureFacts& facts);
CsvRow measure_csv_row(const MeasureFacts& facts, const MeasureRows& rows, const MeasureRow& row,
                       const Provenance& provenance);

// Rows as they are queried, as CSV and as JSON, each with where it comes from.
Definition<std::string> measure_csv(const MeasureQuery& query, const RecordSource& source,
                                    const std::shared_ptr<const Answer>& answer);
Definition<std::string> measure_json(const MeasureQuery& query, const RecordSource& source,
                                     const std::shared_ptr<const Answer>& answer);

}  // namespace alphascope
