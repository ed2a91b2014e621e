// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli formats: lists the formats of files that the programs read and write.
#include <iostream>

#include "app/cli/command.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/result_files.hpp"
#include "app/cli/text/table.hpp"
#include "app/cli/text/terminal.hpp"
#include "core/document/export/complex_export.hpp"
#include "core/read/file_format.hpp"

namespace alphascope::cli {
namespace {

struct FormatsOptions {
  std::string json;
};

std::string endings_text(const FileFormat& format) {
  std::string text;
  for (const std::string_view ending : format.endings) {
    text += (text.empty() ? "" : ", ") + std::string(ending);
  }
  return text;
}

void print_table(const std::vector<std::string>& headings,
                 const std::vector<std::vector<std::string>>& rows) {
  std::vector<TableColumn> columns;
  for (std::size_t c = 0; c < headings.size(); ++c) {
    std::vector<std::string> cells;
    for (const auto& row : rows) cells.push_back(row[c]);
    columns.push_back({headings[c], widest(cells), true});
  }
  const Table table(columns);
  std::cout << table.heading();
  for (const auto& row : rows) std::cout << table.line(row);
}

void print_formats() {
  std::vector<std::vector<std::string>> read, written;
  for (const FileFormat& format : file_formats()) {
    read.push_back({std::string(format.id), std::string(format.name), endings_text(format)});
  }
  for (const ExportFormatInfo& format : export_formats()) {
    written.push_back({"." + std::string(format.id), format.name, format.what});
  }
  std::cout << "Formats that are read, each also packed with gzip (.gz):\n";
  print_table({"--format", "name", "endings"}, read);
  std::cout << "\nFormats of exported complexes:\n";
  print_table({"ending", "name", "content"}, written);
  std::cout << std::flush;
}

Json formats_json() {
  Json json;
  for (const FileFormat& format : file_formats()) {
    Json endings = Json::array();
    for (const std::string_view ending : format.endings) endings.push_back(std::string(ending));
    json["read"].push_back({{"id", std::string(format.id)},
                            {"name", std::string(format.name)},
                            {"endings", std::move(endings)}});
  }
  for (const ExportFormatInfo& format : export_formats()) {
    json["export"].push_back({{"ending", "." + std::string(format.id)},
                              {"name", format.name},
                              {"content", format.what},
                              {"colours", format.colours}});
  }
  json["program"] = program_json();
  return json;
}

ExitCode run_formats(const FormatsOptions& options) {
  Outputs outputs({});
  JsonResults json(outputs.add("--json", options.json, Outputs::kJson), "");
  if (verbosity() != Verbosity::quiet || !outputs.take_standard_output()) print_formats();
  if (json.wanted()) json.add(formats_json());
  json.finish(Json::object());
  outputs.commit();
  return ExitCode::ok;
}

OptionCommand table_of_formats(FormatsOptions& options) {
  return {"formats",
          "List the formats of files that are read and written",
          {output("--json", "The lists as JSON; - for standard output", options.json)}};
}

}  // namespace

Command formats_command() {
  return make_command<FormatsOptions>(table_of_formats, run_formats, {"alphascope-cli formats"});
}

}  // namespace alphascope::cli
