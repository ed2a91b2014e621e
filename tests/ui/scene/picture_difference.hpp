// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of how far two pictures differ.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "ui/scene/scene.hpp"

namespace alphascope::testing {

// Counts pixels whose red, green and blue differ by more than 30 in sum.
inline int differing_pixels(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  int count = 0;
  for (std::size_t i = 0; i + 3 < std::min(a.rgba.size(), b.rgba.size()); i += 4) {
    int difference = 0;
    for (std::size_t c = 0; c < 3; ++c) difference += std::abs(a.rgba[i + c] - b.rgba[i + c]);
    count += difference > 30;
  }
  return count;
}

// Counts pixels with a channel that differs by more than colours rounded in different ways.
inline int unequal_pixels(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  int count = 0;
  for (std::size_t i = 0; i + 3 < std::min(a.rgba.size(), b.rgba.size()); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, std::abs(a.rgba[i + c] - b.rgba[i + c]));
    count += most > 2;
  }
  return count;
}

// Counts pixels without the colour of the picture's corner, which is the background.
inline int drawn_pixels(const Image& image) {
  Image background = image;
  for (std::size_t i = 4; i < image.rgba.size(); ++i) background.rgba[i] = image.rgba[i % 4];
  return differing_pixels(image, background);
}

// Two drivers round differently at edges. Few pixels may differ clearly, and the mean colour
// hardly.
struct PictureDifference {
  double share = 0;  // of pixels outside the range of the nine pixels around them in the other
                     // picture
  double shade = 0;  // largest difference of a channel's mean, of 255
  bool small() const { return share <= 0.002 && shade <= 0.25; }
};

// Share of a's pixels with a channel more than `allowed` outside b's values within a pixel.
inline double share_unlike(const Image& a, const Image& b, int allowed = 16) {
  const auto at = [](const Image& image, int x, int y, std::size_t channel) -> int {
    return image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) + channel];
  };
  const auto unlike = [&](int x, int y) {
    for (std::size_t c = 0; c < 4; ++c) {
      int least = 255, most = 0;
      for (int v = std::max(0, y - 1); v <= std::min(b.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(b.width - 1, x + 1); ++u) {
          least = std::min(least, at(b, u, v, c));
          most = std::max(most, at(b, u, v, c));
        }
      }
      if (at(a, x, y, c) < least - allowed || at(a, x, y, c) > most + allowed) return true;
    }
    return false;
  };
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += unlike(x, y);
  }
  return double(count) / (double(a.width) * a.height);
}

inline std::array<double, 4> mean_colour(const Image& image) {
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) sum[i % 4] += image.rgba[i];
  for (double& s : sum) s /= double(image.rgba.size()) / 4;
  return sum;
}

inline PictureDifference compare_pictures(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return {1, 255};
  PictureDifference result{std::max(share_unlike(a, b), share_unlike(b, a)), 0};
  const auto of_a = mean_colour(a), of_b = mean_colour(b);
  for (std::size_t c = 0; c < 4; ++c)
    result.shade = std::max(result.shade, std::abs(of_a[c] - of_b[c]));
  return result;
}

// Returns a picture of the differences, four times as strong. Both pictures must have the same
// size.
inline Image difference_picture(const Image& a, const Image& b) {
  Image picture = a;
  for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i) {
    picture.rgba[i] = static_cast<std::uint8_t>(std::min(255, 4 * std::abs(a.rgba[i] - b.rgba[i])));
    if (i % 4 == 3) picture.rgba[i] = 255;
  }
  return picture;
}

}  // namespace alphascope::testing
