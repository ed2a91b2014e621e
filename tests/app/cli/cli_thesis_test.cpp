// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the thesis' suite on the command line.
#include <gtest/gtest.h>

#include "tests/app/cli/cli_fixture.hpp"
#include "tests/support/well_formed_xml.hpp"

namespace alphascope::testing {
namespace {

using nlohmann::json;

TEST_F(Cli, ThesisSuiteWritesTheSameNumbersAsCsvAndJsonAndItsFigures) {
  const fs::path csv = folder_ / "suite.csv", out = folder_ / "suite.json",
                 charts = folder_ / "svg";
  const Outcome outcome =
      run("bench '" + cube_.string() +
          "' --suite thesis --alpha 0,1 --runs 1 --engines cpu,tuples-cpu --csv '" + csv.string() +
          "' --json '" + out.string() + "' --charts '" + charts.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("kernel1"), std::string::npos);
  const auto rows = csv_rows(contents(csv));
  const json table = json::parse(contents(out))["rows"];
  ASSERT_EQ(rows.size(), table.size());
  ASSERT_GE(rows.size(), 8u) << "CGAL and two engines at two alphas, and ablations";
  for (std::size_t n = 0; n < rows.size(); ++n) {
    EXPECT_EQ(rows[n].size(), table[n].size());
    for (const auto& [name, value] : table[n].items()) {
      const std::string& text = rows[n].at(name);
      if (value.is_null())
        EXPECT_EQ(text, "") << name;
      else if (value.is_string())
        EXPECT_EQ(text, value.get<std::string>()) << name;
      else if (value.is_boolean())
        EXPECT_EQ(text, value.get<bool>() ? "1" : "0") << name;
      else
        EXPECT_EQ(std::stod(text), value.get<double>()) << name;
    }
    EXPECT_EQ(rows[n].at("same_as_cgal"), "1");
    EXPECT_EQ(rows[n].at("sha256").size(), 64u);
    EXPECT_NE(rows[n].at("cpu"), "");
  }
  const Outcome printed =
      run("bench '" + cube_.string() + "' --suite thesis --alpha 0 --runs 1 --engines cpu --csv -");
  EXPECT_EQ(csv_rows(printed.out).size(), 2u) << "the table and nothing else";
  int figures = 0;
  for (const auto& entry : fs::directory_iterator(charts)) {
    ++figures;
    EXPECT_EQ(test::xml_error(contents(entry.path())), "") << entry.path();
  }
  EXPECT_GE(figures, 5);
}

TEST_F(Cli, ThesisSuiteHasTheRoundsAsTextCsvAndJson) {
  const fs::path csv = folder_ / "rounds.csv", out = folder_ / "suite.json";
  const Outcome outcome = run("bench '" + cube_.string() +
                              "' --suite thesis --alpha 0 --runs 1 --engines cpu --rounds '" +
                              csv.string() + "' --json '" + out.string() + "'");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part :
       {"Part I: the thesis' rounds", "star completion", "usual way", "Part II"}) {
    EXPECT_TRUE(contains(outcome.out, part)) << part << "\n" << outcome.out;
  }
  const auto rows = csv_rows(contents(csv));
  const json table = json::parse(contents(out))["rounds"];
  ASSERT_EQ(rows.size(), table.size());
  ASSERT_GE(rows.size(), 5u) << "a round or more, the completion, and three wholes";
  for (std::size_t n = 0; n < rows.size(); ++n) {
    EXPECT_EQ(rows[n].size(), table[n].size());
    EXPECT_EQ(rows[n].at("tetrahedra"), std::to_string(table[n]["tetrahedra"].get<int>()));
    EXPECT_EQ(rows[n].at("sha256").size(), 64u);
  }
  EXPECT_EQ(table.back()["same_as_cgal"], true);
  EXPECT_EQ(table.back()["tetrahedra"], 6) << "ties are broken as in the whole triangulation";
}

TEST_F(Cli, BenchOptionsThatDoNotGoTogetherAreRefused) {
  const std::string bench = "bench '" + cube_.string() + "' ";
  EXPECT_EQ(run(bench).code, 2);
  EXPECT_EQ(run(bench + "--alpha 0 --charts x").code, 2);
  EXPECT_EQ(run(bench + "--alpha 0 --rounds x").code, 2);
  EXPECT_EQ(run(bench + "--suite thesis --engine cpu").code, 2);
  EXPECT_EQ(run(bench + "--suite thesis --engines cgal").code, 2);
  EXPECT_EQ(run(bench + "--suite thesis --csv - --json -").code, 2);
  const Outcome no_folder = run(
      bench + "--suite thesis --alpha 0 --runs 1 --engines cpu --charts '" + cube_.string() + "'");
  EXPECT_EQ(no_folder.code, 5);
  EXPECT_NE(no_folder.err.find("Cannot make the folder"), std::string::npos);
}

}  // namespace
}  // namespace alphascope::testing
