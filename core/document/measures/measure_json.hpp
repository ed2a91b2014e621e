// Areas and volumes as JSON (docs/output-files.md).
#pragma once

#include "core/document/export/record_json.hpp"
#include "core/document/measures/measure_records.hpp"

namespace alphascope {

// Keys surface, area_angstrom2, volume_angstrom3, components; atoms, residues or chains where the
// rows are those; measured, those of complex_json(), request, input.
Json measures_json(const MeasureFacts& facts, const MeasureRows& rows);

}  // namespace alphascope
