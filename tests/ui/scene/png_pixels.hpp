// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes the pixels of a saved PNG picture.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/png_chunks.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope::testing {

// Undoes one of PNG's five filters for a row of bytes. `above` is the finished row before it.
inline void unfilter(int filter, std::size_t step, const std::uint8_t* above,
                     std::vector<std::uint8_t>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int a = i >= step ? row[i - step] : 0, b = above[i], c = i >= step ? above[i - step] : 0;
    const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
    const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    const int predicted[5] = {0, a, b, (a + b) / 2, paeth};
    row[i] = static_cast<std::uint8_t>(row[i] + predicted[filter]);
  }
}

// Decodes what we write: eight bits a channel, RGB or RGBA, not interlaced.
inline Image pixels_of(const std::string& png) {
  std::string packed;
  Image image;
  std::size_t channels = 0;
  for (const auto& [type, data] : chunks_of(png)) {
    if (type == "IDAT") packed += data;
    if (type != "IHDR") continue;
    image.width = static_cast<int>(number_at(data, 0));
    image.height = static_cast<int>(number_at(data, 4));
    EXPECT_EQ(data.at(8), 8) << "bits";
    EXPECT_TRUE(data.at(9) == 2 || data.at(9) == 6) << "kind of colours";
    channels = data.at(9) == 6 ? 4 : 3;
  }
  const std::size_t line = channels * static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> bytes((line + 1) * static_cast<std::size_t>(image.height));
  uLongf size = bytes.size();
  EXPECT_EQ(
      uncompress(bytes.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
      Z_OK);
  EXPECT_EQ(size, bytes.size());
  std::vector<std::uint8_t> row(line), above(line);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* start = &bytes[static_cast<std::size_t>(y) * (line + 1)];
    row.assign(start + 1, start + 1 + line);
    unfilter(start[0], channels, above.data(), row);
    for (std::size_t i = 0; i < line; i += channels) {
      image.rgba.insert(image.rgba.end(), {row[i], row[i + 1], row[i + 2],
                                           channels == 4 ? row[i + 3] : std::uint8_t{255}});
    }
    above = row;
  }
  return image;
}

inline Image pixels_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return pixels_of(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace alphascope::testing
