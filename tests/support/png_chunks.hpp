// SPDX-License-Identifier: GPL-3.0-or-later
// The chunks of a PNG file.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace alphascope::testing {

inline std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + k));
  }
  return number;
}

// Type and data of each chunk. Every length and checksum must be right.
inline std::vector<std::pair<std::string, std::string>> chunks_of(const std::string& png) {
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

// Uncompressed texts, plain and international, by keyword.
inline std::map<std::string, std::string> texts_of(const std::string& png) {
  std::map<std::string, std::string> texts;
  for (const auto& [type, data] : chunks_of(png)) {
    const std::size_t end = data.find('\0');
    if (type == "tEXt") texts[data.substr(0, end)] = data.substr(end + 1);
    if (type == "iTXt") texts[data.substr(0, end)] = data.substr(end + 5);
  }
  return texts;
}

}  // namespace alphascope::testing
