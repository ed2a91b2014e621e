// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that files, window and terminal get the same cells from one list of columns.
#include "core/document/tables/column.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/document/tables/column_info.hpp"
#include "core/document/tables/column_json.hpp"

namespace alphascope {
namespace {

struct Fruit {
  std::string name;
  std::uint64_t number = 0;
  double mass = 0;  // g
  bool ripe = false;
  bool weighed = true;
};

const Column<Fruit> kColumns[] = {
    {.id = "name", .title = "name", .value = [](const Fruit& f) -> CellValue { return f.name; }},
    {.id = "number",
     .title = "number",
     .value = [](const Fruit& f) -> CellValue { return f.number; }},
    {.id = "mass_g",
     .title = "mass",
     .unit = "g",
     .help = "The mass of one.",
     .value = [](const Fruit& f) { return f.weighed ? CellValue(f.mass) : CellValue(); },
     .text = [](const Fruit& f) { return "about " + measure_text(f.mass); }},
    {.id = "ripe",
     .value = [](const Fruit& f) -> CellValue { return f.ripe; },
     .shown_if = [](const Fruit& f) { return f.weighed; }},
    {.id = "stem",
     .value = [](const Fruit&) -> CellValue { return std::string("short"); },
     .files = InFiles::csv},
    {.id = "skin",
     .value = [](const Fruit&) -> CellValue { return std::string("thin"); },
     .files = InFiles::json},
    {.id = "leaf",
     .title = "leaf",
     .value = [](const Fruit&) -> CellValue { return std::string("green"); },
     .files = InFiles::none}};
constexpr std::span<const Column<Fruit>> kAll(kColumns);

TEST(CellValues, TextsOfFilesWindowAndTerminal) {
  const CellValue third = 1000.0 / 3, seven = std::uint64_t{7000}, yes = true, none;
  EXPECT_EQ(csv_cell(third), "333.33333333333331");
  EXPECT_EQ(readable_cell(third), "333.33");
  EXPECT_EQ(fixed_cell(third, 1, "-"), "333.3");
  EXPECT_EQ(csv_cell(seven), "7000");
  EXPECT_EQ(readable_cell(seven), "7,000");
  EXPECT_EQ(csv_cell(yes), "1");
  EXPECT_EQ(fixed_cell(yes, 3, "-"), "*");
  EXPECT_EQ(csv_cell(none), "");
  EXPECT_EQ(readable_cell(none), "…");
  EXPECT_EQ(fixed_cell(none, 3, "-"), "-");
  EXPECT_EQ(csv_cell(-std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(json_cell(none), nullptr);
  EXPECT_EQ(json_cell(yes), true);
}

TEST(CellValues, ACellWithoutAValueIsLessThanAllOthers) {
  EXPECT_LT(CellValue(), CellValue(-1e300));
  EXPECT_LT(CellValue(), CellValue(false));
  EXPECT_LT(CellValue(2.0), CellValue(10.0));
  EXPECT_LT(CellValue(std::string("a")), CellValue(std::string("b")));
}

TEST(Columns, CsvHasTheColumnsOfCsvInTheirOrder) {
  const CsvRow cells = csv_row_of(kAll, Fruit{"fig", 3, 40.5, true});
  EXPECT_EQ(csv_names(cells), "name,number,mass_g,ripe,stem\n");
  EXPECT_EQ(csv_values(cells), "fig,3,40.5,1,short\n");
  EXPECT_EQ(csv_heading(kAll), "name,number,mass_g,stem\n") << "whatever the row";
  const CsvRow unknown = csv_row_of(kAll, Fruit{"fig", 3, 40.5, true, false});
  EXPECT_EQ(csv_names(unknown), "name,number,mass_g,stem\n") << "ripe is not shown";
  EXPECT_EQ(csv_values(unknown), "fig,3,,short\n");
}

TEST(Columns, JsonTakesNestedValuesBetweenFlatOnes) {
  const Fruit fig{"fig", 3, 40.5, true};
  nlohmann::ordered_json json;
  add_keys(json, kAll, fig, {"mass_g"});
  add_keys_up_to(json, kAll, fig, "number");
  json["seeds"] = {1, 2};
  add_keys_up_to(json, kAll, fig);
  EXPECT_EQ(json.dump(),
            R"({"mass_g":40.5,"name":"fig","number":3,"seeds":[1,2],"ripe":true,"skin":"thin"})");
}

TEST(Columns, TheWindowHasItsOwnTextAndHeadingsHaveUnits) {
  const Fruit fig{"fig", 3, 40.5, true};
  EXPECT_EQ(column_of(kAll, "mass_g").shown_text(fig), "about 40.50");
  EXPECT_EQ(column_of(kAll, "number").shown_text(fig), "3");
  EXPECT_EQ(column_of(kAll, "mass_g").heading(), "mass g");
  EXPECT_EQ(column_of(kAll, "name").heading(), "name");
}

TEST(Columns, AnUnknownColumnIsAnInternalError) {
  nlohmann::ordered_json json;
  EXPECT_THROW(column_of(kAll, "colour"), InternalError);
  EXPECT_THROW(add_keys(json, kAll, Fruit{}, {"colour"}), InternalError);
  EXPECT_THROW(add_keys_up_to(json, kAll, Fruit{}, "colour"), InternalError);
}

TEST(Columns, TheirInfosNameTheFiles) {
  const std::vector<ColumnInfo> infos = infos_of(kAll);
  ASSERT_EQ(infos.size(), 7u);
  EXPECT_EQ(infos[2].id, "mass_g");
  EXPECT_EQ(infos[2].unit, "g");
  EXPECT_EQ(infos[2].help, "The mass of one.");
  EXPECT_STREQ(files_text(infos[2].files), "CSV and JSON");
  EXPECT_STREQ(files_text(infos[4].files), "CSV");
  EXPECT_STREQ(files_text(infos[5].files), "JSON");
  EXPECT_STREQ(files_text(infos[6].files), "screen");
}

}  // namespace
}  // namespace alphascope
