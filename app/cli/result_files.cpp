#include "app/cli/result_files.hpp"

namespace alphascope::cli {
namespace {

// Each line but the first moved right, for an object inside of others; the end of the last is lost.
std::string indented(std::string text, const char* margin) {
  if (text.ends_with('\n')) text.pop_back();
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result += margin;
  }
  return result;
}

}  // namespace

void CsvResults::add(const CsvRow& row) {
  if (!wanted()) return;
  file_->write((begun_ ? "" : csv_names(row)) + csv_values(row));
  begun_ = true;
}

void JsonResults::add(Json result) {
  if (!wanted()) return;
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
      failed.push_back({{"file", file}, {"error", message}});
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
