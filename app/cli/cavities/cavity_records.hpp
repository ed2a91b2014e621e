// SPDX-License-Identifier: GPL-3.0-or-later
// Records of cavities for programs (docs/output-files.md), with the command line's additions.
#pragma once

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/report_json.hpp"

namespace alphascope::cli {

// The result with notes and times.
Json result_json(const CavityAnswer& answer, const CavitiesOptions& options);

// Returns cavity_header() with the notes of the molecule's reader.
std::vector<std::pair<std::string, std::string>> noted_header(const CavityAnswer& answer);

}  // namespace alphascope::cli
