// SPDX-License-Identifier: GPL-3.0-or-later
// Writes results one by one, so that ten thousand take no more memory than one. The files belong to
// Outputs, and are null if not requested. All functions throw WriteError.
#pragma once

#include <string>

#include "app/cli/many_files.hpp"
#include "app/cli/report_json.hpp"
#include "core/files/atomic_file.hpp"
#include "core/write/csv.hpp"

namespace alphascope::cli {

// One row a result, below the names of the first row's columns. Rows are written in pieces of a
// quarter megabyte; flush() writes the rest.
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

// Writes one JSON object. With `list`, the results are a list under this key, and further keys
// follow. Without `list`, the object is the only result, with further keys.
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

// The further keys of compute and info: "program" and, for many files, "failed": [{"file",
// "error"}].
Json further_json(const FilesOutcome& outcome, bool many);

}  // namespace alphascope::cli
