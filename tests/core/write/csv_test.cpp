// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that cells are quoted so that pandas, R and spreadsheets read tables back unchanged.
#include "core/write/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alphascope {
namespace {

TEST(Csv, FieldsAreQuotedWhereAReaderWouldSplitThem) {
  const std::vector<CsvRow> rows{{{"plain", "a b"}, {"with,comma", "1,4"}, {"empty", ""}},
                                 {{"plain", "say \"hi\""}, {"", "two\nlines"}, {"", "cr\rcr"}}};
  EXPECT_EQ(csv_text(rows),
            "plain,\"with,comma\",empty\n"
            "a b,\"1,4\",\n"
            "\"say \"\"hi\"\"\",\"two\nlines\",\"cr\rcr\"\n");
  EXPECT_EQ(csv_text({}), "");
}

TEST(Csv, TextsThatSpreadsheetsWouldComputeGetAnApostrophe) {
  for (const char* text : {"=1+1", "+C", "-B", "@x", "--", "-", "=", "\tx", "\rx", "'=x", "''@x",
                           "-1.5x", "+-1", "- 1", "=cmd|' /C calc'!A0"}) {
    EXPECT_EQ(safe_cell(text), std::string("'") + text);
    EXPECT_EQ(plain_cell(safe_cell(text)), text);
  }
  for (const char* text : {"", "a", "1", "-1.5", "+2", "-1e-30", "-1e400", "+.5", "-inf", "'", "'a",
                           "'5", "O5'", " =1", "A=1", "a+b"}) {
    EXPECT_EQ(safe_cell(text), text);
    EXPECT_EQ(plain_cell(text), text);
  }
  EXPECT_EQ(csv_text({{{"=name", "=value"}, {"n", "-1"}}}), "'=name,n\n'=value,-1\n");
  // Some spreadsheets split cells at semicolons, and all of them do in comments.
  EXPECT_EQ(csv_values({{"", "a;=b"}}), "\"a;=b\"\n");
  EXPECT_EQ(csv_comments({"file: a,=b; -c, d=e"}), "# file: a,'=b; '-c, d=e\n");
}

TEST(Csv, WhatIsNoNumberIsAnEmptyField) {
  EXPECT_EQ(csv_milliseconds(15.88434), "15.8843");
  for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_EQ(csv_milliseconds(none), "");
}

}  // namespace
}  // namespace alphascope
