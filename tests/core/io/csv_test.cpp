// Tables that pandas, R and spreadsheets read back as they were.
#include "core/io/csv.hpp"

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

TEST(Csv, WhatIsNoNumberIsAnEmptyField) {
  EXPECT_EQ(csv_milliseconds(15.88434), "15.8843");
  for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_EQ(csv_milliseconds(none), "");
}

}  // namespace
}  // namespace alphascope
