// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities as JSON (docs/output-files.md).
#pragma once

#include "core/document/cavities/cavity_records.hpp"
#include "core/document/export/record_json.hpp"

namespace alphascope {

// Keys comparable_with_castp, differences_from_castp, counts, cavities, split_networks,
// request, input.
Json cavities_json(const CavityFacts& facts);

}  // namespace alphascope
