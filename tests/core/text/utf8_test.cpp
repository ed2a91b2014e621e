// SPDX-License-Identifier: GPL-3.0-or-later
// Tests where characters of UTF-8 begin.
#include "core/text/utf8.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <string_view>

namespace alphascope {
namespace {

TEST(Utf8, CountsCharacters) {
  EXPECT_EQ(character_count(""), 0u);
  EXPECT_EQ(character_count("abc"), 3u);
  EXPECT_EQ(character_count("α = 1 Å²"), 8u);
  EXPECT_EQ(character_count("…😀"), 2u);
}

TEST(Utf8, KnowsBytesThatContinueACharacter) {
  const std::string_view text = "aÅ…";  // 1, 2 and 3 bytes
  const bool expected[] = {false, false, true, false, true, true};
  ASSERT_EQ(text.size(), std::size(expected));
  for (std::size_t n = 0; n < text.size(); ++n) {
    EXPECT_EQ(continues_character(text[n]), expected[n]) << n;
  }
}

}  // namespace
}  // namespace alphascope
