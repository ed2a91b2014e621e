// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the texture into which the scene was drawn. Needs the OpenGL context of that drawing.
#pragma once

#include <GL/gl.h>

#include "ui/scene/scene.hpp"

namespace alphascope::testing {

// In OpenGL's order, with the bottom row first.
inline Image texture_pixels(unsigned texture) {
  Image image;
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &image.width);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &image.height);
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) *
                    static_cast<std::size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;  // as it is read
  return image;
}

// With the top row first, as in saved pictures.
inline Image upright(const Image& image) {
  Image result{image.width, image.height, {}};
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for (int y = image.height - 1; y >= 0; --y) {
    const auto start = image.rgba.begin() + static_cast<long>(static_cast<std::size_t>(y) * row);
    result.rgba.insert(result.rgba.end(), start, start + static_cast<long>(row));
  }
  return result;
}

}  // namespace alphascope::testing
