// SPDX-License-Identifier: GPL-3.0-or-later
// Unpacks the icon's PNG files.
#include "ui/window/window_icon.hpp"

#include <stb/stb_image.h>

#include <cstddef>
#include <span>
#include <utility>

#include "ui/embedded_file.hpp"

ALPHASCOPE_EMBEDDED_FILE(icon_16, ALPHASCOPE_ICONS "/16.png");
ALPHASCOPE_EMBEDDED_FILE(icon_32, ALPHASCOPE_ICONS "/32.png");
ALPHASCOPE_EMBEDDED_FILE(icon_48, ALPHASCOPE_ICONS "/48.png");
ALPHASCOPE_EMBEDDED_FILE(icon_128, ALPHASCOPE_ICONS "/128.png");

namespace alphascope {

std::vector<IconPicture> window_icon() {
  const std::span<const unsigned char> files[] = {
      {alphascope_icon_16_begin, alphascope_icon_16_end},
      {alphascope_icon_32_begin, alphascope_icon_32_end},
      {alphascope_icon_48_begin, alphascope_icon_48_end},
      {alphascope_icon_128_begin, alphascope_icon_128_end}};
  std::vector<IconPicture> pictures;
  for (const std::span<const unsigned char> file : files) {
    IconPicture picture;
    int channels = 0;
    unsigned char* const pixels = stbi_load_from_memory(
        file.data(), static_cast<int>(file.size()), &picture.width, &picture.height, &channels, 4);
    if (pixels == nullptr) continue;  // too little memory; a window needs no icon
    const std::size_t bytes =
        std::size_t{4} * static_cast<std::size_t>(picture.width * picture.height);
    picture.rgba.assign(pixels, pixels + bytes);
    stbi_image_free(pixels);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace alphascope
