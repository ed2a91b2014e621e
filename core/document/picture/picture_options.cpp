// SPDX-License-Identifier: GPL-3.0-or-later
// Writes and reads backgrounds of pictures as words, and lengths in print.
#include "core/document/picture/picture_options.hpp"

#include <cmath>
#include <utility>

#include "core/chart/colour_text.hpp"

namespace alphascope {
namespace {

constexpr std::pair<const char*, PictureBackground> kWords[] = {{"theme", {}},
                                                                {"white", kWhiteBackground},
                                                                {"black", kBlackBackground},
                                                                {"transparent", kNoBackground}};

}  // namespace

std::string background_text(const PictureBackground& background) {
  for (const auto& [word, meaning] : kWords) {
    if (background == meaning) return word;
  }
  return background.transparent ? "transparent" : colour_text(*background.colour);
}

std::optional<PictureBackground> read_background(std::string_view text) {
  for (const auto& [word, meaning] : kWords) {
    if (text == word) return meaning;
  }
  const std::optional<Rgb8> colour = read_colour(text);
  if (!colour) return std::nullopt;
  return PictureBackground{false, colour};
}

bool is_light(const Rgb8& c) {
  // Rec. 709 weights of the components, without linearising them: the middle of the scale is then
  // about CIE L* 50.
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b >= 128;
}

int pixels_of(double millimetres, int dpi) {
  return static_cast<int>(std::lround(millimetres * dpi / kMillimetresPerInch));
}

}  // namespace alphascope
