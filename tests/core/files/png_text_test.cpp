// SPDX-License-Identifier: GPL-3.0-or-later
// Tests texts in PNG files.
#include "core/files/png_text.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/png_chunks.hpp"

namespace alphascope {
namespace {

using testing::chunks_of;

// One transparent pixel.
const std::string kPixel(
    "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\1\0\0\0\1\x08\6\0\0\0\x1f\x15\xc4\x89"
    "\0\0\0\x0aIDATx\x9c\x63\0\1\0\0\5\0\1\x0d\x0a\x2d\xb4\0\0\0\0IEND\xae\x42\x60\x82",
    67);

TEST(PngText, AddsChunksBehindTheHeaderAndKeepsTheRest) {
  const auto before = chunks_of(kPixel);
  ASSERT_EQ(before.size(), 3u);
  const auto after = chunks_of(with_png_text(kPixel, {{"Software", "x 1"}, {"alpha", "1.4 Å²"}}));
  ASSERT_EQ(after.size(), 5u);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1].first, "tEXt");
  EXPECT_EQ(after[1].second, std::string("Software\0x 1", 12));
  EXPECT_EQ(after[2].first, "iTXt");
  EXPECT_EQ(after[2].second, std::string("alpha\0\0\0\0\0", 10) + "1.4 Å²");
  EXPECT_EQ(after[3], before[1]);
  EXPECT_EQ(after[4], before[2]);
}

TEST(PngText, RefusesWhatIsNoPng) {
  EXPECT_THROW(with_png_text("GIF89a", {}), std::invalid_argument);
  EXPECT_THROW(with_png_text(kPixel.substr(0, 20), {}), std::invalid_argument);
}

TEST(PngText, StatesTheResolutionInPixelsPerMetre) {
  const auto after = chunks_of(with_png_resolution(kPixel, 300));
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[1].first, "pHYs");
  // 300 / 0.0254 = 11811 = 0x2e23, twice; unit 1 is the metre.
  EXPECT_EQ(after[1].second, std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));
  EXPECT_THROW(with_png_resolution("GIF89a", 300), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
