// Cavities as programs read them (docs/output-files.md), with what the command line adds.
#pragma once

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/report_json.hpp"

namespace alphascope::cli {

// With notes and times.
Json result_json(const CavityAnswer& answer, const CavitiesOptions& options);

// cavity_header() with the notes of the molecule's reader.
std::vector<std::pair<std::string, std::string>> noted_header(const CavityAnswer& answer);

}  // namespace alphascope::cli
