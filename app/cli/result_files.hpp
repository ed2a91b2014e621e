// Results written as they come, so that ten thousand of them take no more memory than one. Files
// are those of Outputs; null for what nobody asked for. All throw WriteError.
#pragma once

#include <string>

#include "app/cli/many_files.hpp"
#include "app/cli/report_json.hpp"
#include "core/files/atomic_file.hpp"
#include "core/write/csv.hpp"

namespace alphascope::cli {

// One row a result, below a line with the names of the first row. Written a quarter of a megabyte
// at a time; flush() writes the rest.
class CsvResults {
 public:
  explicit CsvResults(AtomicFile* file) : file_(file) {}
  bool wanted() const { return file_ != nullptr; }
  void add(const CsvRow& row);
  void flush();

 private:
  AtomicFile* file_;
  std::string waiting_;
  bool begun_ = false;
};

// One object: the results as a list under the key `list` and further keys behind it; without `list`
// the one result with further keys.
class JsonResults {
 public:
  JsonResults(AtomicFile* file, std::string list) : file_(file), list_(std::move(list)) {}
  bool wanted() const { return file_ != nullptr; }
  void add(Json result);
  void finish(const Json& further);

 private:
  AtomicFile* file_;
  std::string list_;
  Json one_ = Json::object();
  bool begun_ = false;
};

// The further keys of compute and info: of many files "failed", [{"file", "error"}]; "program".
Json further_json(const FilesOutcome& outcome, bool many);

}  // namespace alphascope::cli
