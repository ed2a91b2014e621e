// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes as JSON (docs/output-files.md).
#pragma once

#include "core/document/export/record_json.hpp"
#include "core/document/measures/measure_records.hpp"

namespace alphascope {

// Keys surface, area_angstrom2, volume_angstrom3, components, measured, those of complex_json(),
// request, input. Also atoms, residues or chains, if the rows are those.
Json measures_json(const MeasureFacts& facts, const MeasureRows& rows);

}  // namespace alphascope
