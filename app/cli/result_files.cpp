// SPDX-License-Identifier: GPL-3.0-or-later
// Writes results to CSV and JSON files one by one.
#include "app/cli/result_files.hpp"

#include "app/cli/text/terminal.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

constexpr std::size_t kBuffered = 1 << 18;  // bytes

// Indents each line but the first, for an object inside others. Drops the last line end.
std::string indented(std::string text, const char* margin) {
  if (text.ends_with('\n')) text.pop_back();
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result += margin;
  }
  return result;
}

// Empties columns that depend on the run, such as times. The columns themselves stay, so tables of
// several runs can be joined.
CsvRow without_run(CsvRow row) {
  for (auto& [name, value] : row) {
    for (const char* of_run : {"wall_ms", "device", "route", "measured_by"}) {
      if (name == of_run) value.clear();
    }
  }
  return row;
}

}  // namespace

void CsvResults::add(const CsvRow& row) {
  if (!wanted()) return;
  if (!begun_) waiting_ = csv_names(row);
  begun_ = true;
  waiting_ += csv_values(times_wanted() ? row : without_run(row));
  if (waiting_.size() >= kBuffered) flush();
}

void CsvResults::flush() {
  if (waiting_.empty()) return;
  file_->write(waiting_);
  waiting_.clear();
}

void JsonResults::add(Json result) {
  if (!wanted()) return;
  result = json_to_write(std::move(result));
  if (list_.empty()) {
    one_ = std::move(result);
    return;
  }
  file_->write((begun_ ? ",\n    " : "{\n  \"" + list_ + "\": [\n    ") +
               indented(json_text(result), "    "));
  begun_ = true;
}

Json further_json(const FilesOutcome& outcome, bool many) {
  Json further = Json::object();
  if (many) {
    Json& failed = further["failed"] = Json::array();
    for (const auto& [file, message] : outcome.failed) {
      failed.push_back({{"file", file}, {"error", printable(message)}});
    }
  }
  further["program"] = program_json();
  return further;
}

void JsonResults::finish(const Json& further) {
  if (!wanted()) return;
  if (list_.empty()) {
    one_.update(further);
    file_->write(json_text(one_));
  } else {
    std::string text = begun_ ? "\n  ]" : "{\n  \"" + list_ + "\": []";
    for (const auto& [key, value] : further.items()) {
      text += ",\n  " + Json(key).dump() + ": " + indented(json_text(value), "  ");
    }
    file_->write(text + "\n}\n");
  }
}

}  // namespace alphascope::cli
