// A table where --csv says: a file, or standard output.
#pragma once

#include "core/io/csv.hpp"

namespace alphascope::cli {

// To a file, whole or not at all; "-" is standard output. Throws WriteError.
void put_csv(const std::vector<CsvRow>& rows, const std::string& path);

}  // namespace alphascope::cli
