// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the command `columns` lists what the files of other commands have.
#include "tests/app/cli/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

const std::string kCrambin = "'" ALPHASCOPE_SOURCE_DIR "/resources/molecules/1crn.pdb' ";

class CliColumns : public Cli {
 protected:
  // Names of the listed columns that CSV has, joined as in its first line.
  std::string listed(const std::string& table) const {
    std::string names;
    const auto rows = csv_rows(run("columns " + table + " -q --csv -").out);
    EXPECT_GE(rows.size(), 4u) << table;
    for (const auto& row : rows) {
      if (contains(row.at("files"), "CSV")) names += row.at("column") + ",";
    }
    return names;
  }
};

TEST_F(CliColumns, TheListBeginsTheFirstLineOfTheCsv) {
  const std::pair<std::string, std::string> cases[] = {
      {"info", "info -q --csv - " + kCrambin},
      {"compute", "compute -q --alpha 1 --csv - " + kCrambin},
      {"cavities", "cavities -q --csv - " + kCrambin},
      {"channel", "channel -q --csv - --way 1 " + kCrambin},
      {"measure", "measure -q --csv - --per atom --derivatives " + kCrambin},
      {"bench", "bench -q --alpha 0 --runs 1 --csv - " + kCrambin},
      {"suite", "bench -q --suite thesis --alpha 0 --runs 1 --engines cpu --csv - " + kCrambin},
      {"rounds",
       "bench -q --suite thesis --alpha 0 --runs 1 --engines cpu --rounds - " + kCrambin}};
  for (const auto& [table, command] : cases) {
    const Outcome written = run(command);
    ASSERT_EQ(written.code, 0) << command << written.err;
    EXPECT_TRUE(written.out.starts_with(listed(table))) << table << "\n" << written.out;
  }
}

TEST_F(CliColumns, JsonHasTheKeysOfTheList) {
  const json cavity = json::parse(run("cavities -q --json - " + kCrambin).out).at("cavities").at(0);
  std::size_t keys = 0;
  for (const auto& row : csv_rows(run("columns cavities -q --csv -").out)) {
    if (!contains(row.at("files"), "JSON")) continue;
    ++keys;
    EXPECT_TRUE(cavity.contains(row.at("column"))) << row.at("column");
  }
  EXPECT_GT(keys, 20u);
}

TEST_F(CliColumns, EachColumnHasAMeaning) {
  const auto rows = csv_rows(run("columns -q --csv -").out);
  ASSERT_GT(rows.size(), 100u);
  for (const auto& row : rows) EXPECT_NE(row.at("meaning"), "") << row.at("column");
  const std::string text = run("columns lives").out;
  EXPECT_TRUE(contains(text, "  gone_alpha_angstrom2, Å² (CSV)\n")) << text;
}

}  // namespace
}  // namespace alphascope::testing
