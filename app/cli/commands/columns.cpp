// SPDX-License-Identifier: GPL-3.0-or-later
// Runs alphascope-cli columns: lists the columns of the program's tables, with unit and meaning.
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "app/bench/rounds_suite.hpp"
#include "app/bench/thesis_table.hpp"
#include "app/cli/cavities/comparison_columns.hpp"
#include "app/cli/command.hpp"
#include "app/cli/commands/columns.hpp"
#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "app/cli/text/terminal.hpp"
#include "core/document/cavities/cavity_bars.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/document/channels/channel_columns.hpp"
#include "core/document/measures/measure_columns.hpp"
#include "core/document/reference/measurement_columns.hpp"
#include "core/document/tables/column_info.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope::cli {
namespace {

struct ColumnsOptions {
  std::string table;  // empty: all
  std::string csv;
};

std::vector<TableInfo> all_tables() {
  return {
      {"info", "a row for each file or model", info_columns()},
      {"compute", "a row for each file or model", compute_columns()},
      {"cavities", "a row for each cavity", infos_of(cavity_columns())},
      {"variants", "a row for each compared radii set and solvent radius",
       infos_of(variant_columns())},
      {"side_by_side", "a row for each cavity of the first variant",
       infos_of(compared_cavity_columns())},
      {"counterparts", "a row for each variant of such a cavity", infos_of(counterpart_columns())},
      {"lives", "a row for each cavity at any alpha", infos_of(life_columns())},
      {"channel", "a row for each sample of the centre line", infos_of(sample_columns())},
      {"ways", "a row for each way through the molecule", infos_of(way_columns())},
      {"measure", "a row for each group", infos_of(measure_columns())},
      {"distances", "a row for each distance or angle that the window copies",
       infos_of(measurement_columns())},
      {"bench", "a row for each file, number of threads and alpha", bench_columns()},
      {"suite", "a row for each measurement of the thesis' suite", infos_of(thesis_columns())},
      {"rounds", "a row for each of the thesis' rounds, and for each whole triangulation",
       infos_of(rounds_columns())}};
}

std::string table_ids(const char* between) {
  std::string ids;
  for (const TableInfo& table : all_tables()) ids += (ids.empty() ? "" : between) + table.id;
  return ids;
}

// A row of the printed list: a column, and the table that it belongs to.
struct ListedColumn {
  const TableInfo& table;
  const ColumnInfo& info;
};

const Column<ListedColumn> kColumns[] = {
    {.id = "table", .value = [](const ListedColumn& c) -> CellValue { return c.table.id; }},
    {.id = "column", .value = [](const ListedColumn& c) -> CellValue { return c.info.id; }},
    {.id = "title", .value = [](const ListedColumn& c) -> CellValue { return c.info.title; }},
    {.id = "unit", .value = [](const ListedColumn& c) -> CellValue { return c.info.unit; }},
    {.id = "files",
     .value = [](const ListedColumn& c) -> CellValue { return files_text(c.info.files); }},
    {.id = "meaning", .value = [](const ListedColumn& c) -> CellValue { return c.info.help; }}};
constexpr std::span<const Column<ListedColumn>> kAllColumns(kColumns);

void print(const TableInfo& table) {
  std::cout << table.id << ": " << table.text << "\n";
  for (const ColumnInfo& info : table.columns) {
    std::cout << "  " << info.id << (info.unit.empty() ? "" : ", ") << info.unit << " ("
              << files_text(info.files) << ")\n      " << info.help << "\n";
  }
}

ExitCode run_columns(const ColumnsOptions& options) {
  Outputs outputs({});
  AtomicFile* const csv = outputs.add("--csv", options.csv, Outputs::kCsv);
  const bool shown = verbosity() != Verbosity::quiet || !outputs.take_standard_output();
  std::string text = csv_heading(kAllColumns);
  for (const TableInfo& table : all_tables()) {
    if (!options.table.empty() && table.id != options.table) continue;
    if (shown) print(table);
    for (const ColumnInfo& info : table.columns) {
      text += csv_values(csv_row_of(kAllColumns, {table, info}));
    }
  }
  std::cout << std::flush;
  if (csv) csv->write(text);
  outputs.commit();
  return ExitCode::ok;
}

OptionCommand table_of_columns(ColumnsOptions& options) {
  OptionCommand command{"columns", "List the columns of tables, with unit and meaning", {}};
  Option table =
      choice_option({"TABLE", table_ids("|"), "One of " + table_ids(", ")}, options.table);
  table.fallback = "all";
  command.options = {table, output("--csv", "The list as CSV; - for standard output", options.csv)};
  return command;
}

}  // namespace

Command columns_command() {
  return make_command<ColumnsOptions>(table_of_columns, run_columns,
                                      {"alphascope-cli columns cavities"});
}

}  // namespace alphascope::cli
