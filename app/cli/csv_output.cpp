#include "app/cli/csv_output.hpp"

#include <iostream>

#include "core/io/atomic_file.hpp"

namespace alphascope::cli {

void put_csv(const std::vector<CsvRow>& rows, const std::string& path) {
  if (path != "-") return write_csv(rows, path);
  std::cout << csv_text(rows) << std::flush;
  if (!std::cout) throw WriteError("Cannot write to standard output.");
}

}  // namespace alphascope::cli
