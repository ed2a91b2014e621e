// From OpenGL framebuffers to images and PNG files.
#pragma once

#include <filesystem>

#include "ui/scene/scene.hpp"

namespace alphascope {

// The colours of framebuffer `framebuffer` (0: the window's), lower left corner at (0, 0).
Image read_framebuffer(unsigned framebuffer, int width, int height);

// Means of factor x factor pixels; weighted by alpha, so that transparent pixels give no colour.
Image downsample(const Image& image, int factor);

// Throws std::runtime_error naming the path when it cannot be written.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace alphascope
