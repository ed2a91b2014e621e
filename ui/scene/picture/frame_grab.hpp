// From OpenGL framebuffers to images and PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/run/cancel_token.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

// The colours of framebuffer `framebuffer` (0: the window's), lower left corner at (0, 0).
Image read_framebuffer(unsigned framebuffer, int width, int height);

// Colours as OpenGL blends them, multiplied by alpha, as files have them.
void divide_by_alpha(Image& premultiplied);

// Keyword and text, as with_png_text() takes them (core/files/png_text.hpp).
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

// The file appears whole or not at all. Throws WriteError naming the path when it cannot be
// written, and Cancelled, which leaves an older file as it is.
void write_png(const Image& image, const std::filesystem::path& path,
               const PictureTexts& texts = {}, const CancelToken& cancel = {});

}  // namespace alphascope
