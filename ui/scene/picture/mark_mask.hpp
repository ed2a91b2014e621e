// SPDX-License-Identifier: GPL-3.0-or-later
// Masks of coverage for marks over a picture: boxes, texts in the window's font, and rims around
// both. They are sharp at any size, because letters are drawn from outlines in the picture's own
// pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ui/inter_font.hpp"
#include "ui/picture_marks.hpp"

namespace alphascope {

// Coverage, 0 to 255, of a rectangle of the picture; top row first. The rectangle may extend beyond
// the picture.
struct MarkMask {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
};

MarkMask mask_of(const MarkBox& box);
// The largest coverage within a distance of `reach` pixels, which makes corners round.
MarkMask rim_of(const MarkMask& mask, int reach);

// The font Inter (ui/inter_font.hpp) in one size. Characters that the font lacks appear as an empty
// box.
class MarkLetters {
 public:
  // Throws std::runtime_error if FreeType fails.
  explicit MarkLetters(float pixels_of_an_em,
                       std::span<const unsigned char> font = inter_regular());
  ~MarkLetters();
  MarkLetters(const MarkLetters&) = delete;
  MarkLetters& operator=(const MarkLetters&) = delete;

  MarkMask mask(const MarkText& text) const;
  float width(const std::string& text) const;
  float line_height() const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace alphascope
