#include "core/io/png_text.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <stdexcept>

namespace alphascope {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + k));
  }
  return number;
}

// A picture's chunks: type and data. Every length and checksum must be right.
std::vector<std::pair<std::string, std::string>> chunks_of(const std::string& png) {
  std::vector<std::pair<std::string, std::string>> chunks;
  std::size_t at = 8;
  while (at < png.size()) {
    const std::uint32_t length = number_at(png, at);
    const std::string body = png.substr(at + 4, length + 4);
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())),
              number_at(png, at + 8 + length));
    chunks.emplace_back(body.substr(0, 4), body.substr(4));
    at += 12 + length;
  }
  EXPECT_EQ(at, png.size());
  return chunks;
}

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
  EXPECT_EQ(after[1].first, "iTXt");
  EXPECT_EQ(after[1].second, std::string("Software\0\0\0\0\0x 1", 16));
  EXPECT_EQ(after[2].second, std::string("alpha\0\0\0\0\0", 10) + "1.4 Å²");
  EXPECT_EQ(after[3], before[1]);
  EXPECT_EQ(after[4], before[2]);
}

TEST(PngText, RefusesWhatIsNoPng) {
  EXPECT_THROW(with_png_text("GIF89a", {}), std::invalid_argument);
  EXPECT_THROW(with_png_text(kPixel.substr(0, 20), {}), std::invalid_argument);
}

}  // namespace
}  // namespace alphascope
