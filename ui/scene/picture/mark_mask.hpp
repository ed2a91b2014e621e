// Coverage of what is laid over a picture: boxes, texts in the window's letters, and rims around
// both. Sharp at any size: letters are drawn from their outlines in the picture's own pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ui/inter_font.hpp"
#include "ui/picture_marks.hpp"

namespace alphascope {

// Coverage, 0 to 255, of a part of the picture that may stick out of it; top row first.
struct MarkMask {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<std::uint8_t> coverage;
};

MarkMask mask_of(const MarkBox& box);
// The largest coverage within `reach` pixels: corners are round.
MarkMask rim_of(const MarkMask& mask, int reach);

// Inter (ui/inter_font.hpp), in one size. A letter that the font lacks is an empty box.
class MarkLetters {
 public:
  // Throws std::runtime_error when FreeType does not work.
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
