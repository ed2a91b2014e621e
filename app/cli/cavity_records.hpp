// Cavities as programs read them (docs/output-files.md).
#pragma once

#include "app/cli/cavity_answer.hpp"
#include "app/cli/report_json.hpp"
#include "core/io/csv.hpp"

namespace alphascope::cli {

// `first_id`: the id of the cavity of the first radii and solvent radius that it is; 0 for none.
CsvRow csv_row(const CavityAnswer& answer, std::size_t row, std::size_t first_id);
Json result_json(const CavityAnswer& answer, const CavitiesOptions& options);

// Where it comes from and what was asked, for whatever else is written of it.
std::vector<std::pair<std::string, std::string>> cavity_header(const CavityAnswer& answer);

}  // namespace alphascope::cli
