// SPDX-License-Identifier: GPL-3.0-or-later
// Choices for saved pictures and recordings, which sessions keep.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/recording.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {

// The background of a saved picture: the theme's, a colour, or none.
struct PictureBackground {
  bool transparent = false;         // then the colour has no effect
  std::optional<Rgb8> colour = {};  // none: the theme's
  friend bool operator==(const PictureBackground&, const PictureBackground&) = default;
};

inline constexpr PictureBackground kNoBackground{true, {}};
inline constexpr PictureBackground kWhiteBackground{false, Rgb8{255, 255, 255}};
inline constexpr PictureBackground kBlackBackground{false, Rgb8{0, 0, 0}};
// For help and messages.
inline constexpr const char* kBackgroundWords =
    "theme, white, black, transparent, or a colour such as #f4f4f4";

std::string background_text(const PictureBackground& background);  // "white", "#f4f4f4"
// Reads one of kBackgroundWords. Returns nothing for any other text.
std::optional<PictureBackground> read_background(std::string_view text);

// Whether dark letters and lines are readable on this colour.
bool is_light(const Rgb8& colour);

struct PictureOptions {
  int width = 1920, height = 1080;  // pixels
  int dpi = 300;                    // dots per inch, which the file states
  PictureBackground background = {};
  double letters = 1;  // factor on the size of legend, scale bar, caption, labels
  bool legend = true, scale_bar = false;  // the legend is drawn if colours have a meaning
  CaptionParts caption = {};
  friend bool operator==(const PictureOptions&, const PictureOptions&) = default;
};

// Lengths in print.
constexpr double kMillimetresPerInch = 25.4;
inline double millimetres(int pixels, int dpi) {
  return pixels * kMillimetresPerInch / dpi;
}
// The nearest number of pixels.
int pixels_of(double millimetres, int dpi);

struct RecordSettings {
  Recording recording;
  bool of_lesson = false;      // record a lesson instead
  double lesson_seconds = 10;  // duration of each step in a movie
  PictureOptions options{.width = 1280, .height = 720, .caption = usual_caption()};
  friend bool operator==(const RecordSettings&, const RecordSettings&) = default;
};

}  // namespace alphascope
