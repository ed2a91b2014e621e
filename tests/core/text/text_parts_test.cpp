// SPDX-License-Identifier: GPL-3.0-or-later
// Tests parts and words of texts.
#include "core/text/text_parts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace alphascope {
namespace {

using Texts = std::vector<std::string>;

TEST(TextParts, AreBetweenSeparators) {
  EXPECT_EQ(parts_of("a,bc,,d", ','), (Texts{"a", "bc", "", "d"}));
  EXPECT_EQ(parts_of("a,", ','), (Texts{"a"}));  // as std::getline reads lines
  EXPECT_EQ(parts_of(",a", ','), (Texts{"", "a"}));
  EXPECT_EQ(parts_of(",", ','), (Texts{""}));
  EXPECT_EQ(parts_of("", ','), Texts{});
  EXPECT_EQ(parts_of("a|b,c", '|'), (Texts{"a", "b,c"}));
  EXPECT_EQ(parts_of(std::string("a\0b", 3), '\0'), (Texts{"a", "b"}));
}

TEST(TextParts, WordsAreBetweenBlanks) {
  EXPECT_EQ(words_of("  one two\t\nthree  "), (Texts{"one", "two", "three"}));
  EXPECT_EQ(words_of("one"), (Texts{"one"}));
  EXPECT_EQ(words_of(" \n\t "), Texts{});
  EXPECT_EQ(words_of(""), Texts{});
  EXPECT_EQ(words_of("a\u00a0b c"), (Texts{"a\u00a0b", "c"}));  // no break there
}

}  // namespace
}  // namespace alphascope
