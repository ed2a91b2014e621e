// SPDX-License-Identifier: GPL-3.0-or-later
// Images from OpenGL framebuffers, and PNG files of images.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

// The colours of `framebuffer` (0: the window's), from its lower left corner.
Image read_framebuffer(unsigned framebuffer, int width, int height);

// OpenGL multiplies colours by alpha; files store them undivided. This divides colours by alpha.
void divide_by_alpha(Image& premultiplied);

// Pairs of keyword and text, as with_png_text() takes them (core/files/png_text.hpp).
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

// The bytes of a PNG file. `dpi`: dots per inch that it states; 0: none.
std::string png_bytes(const Image& image, const PictureTexts& texts, int dpi = 0);

// The file appears whole or not at all. Throws WriteError with the path if it cannot be written.
// Throws Cancelled, and then leaves an older file as it is.
void write_png(const Image& image, const std::filesystem::path& path,
               const PictureTexts& texts = {}, const CancelToken& cancel = {}, int dpi = 0);

}  // namespace alphascope
