// SPDX-License-Identifier: GPL-3.0-or-later
// Draws boxes, rims and letters into masks. Letters have fractional positions, so their distances
// are right at small sizes too. FreeType's light hinting fits heights to whole pixels, as in the
// window.
#include "ui/scene/picture/mark_mask.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

constexpr float kSubpixels = 64;  // FreeType's unit of 1/64 pixel
constexpr int kDotsPerInch = 72;  // makes a point equal to a pixel

int whole(float v) {
  return static_cast<int>(std::lround(v));
}

// Reads a character of correct UTF-8 and moves `at` behind it.
char32_t character_at(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  char32_t character = first < 0xe0 ? first & 0x1f : first < 0xf0 ? first & 0x0f : first & 0x07;
  while (at < text.size() && continues_character(text[at])) {
    character = character << 6 | (static_cast<unsigned char>(text[at++]) & 0x3f);
  }
  return character;
}

void put_on(MarkMask& mask, const FT_Bitmap& letter, int left, int top) {
  for (int row = 0; row < static_cast<int>(letter.rows); ++row) {
    const int y = top + row;
    if (y < 0 || y >= mask.height) continue;
    for (int column = 0; column < static_cast<int>(letter.width); ++column) {
      const int x = left + column;
      if (x < 0 || x >= mask.width) continue;
      std::uint8_t& target = mask.coverage[std::size_t(y) * mask.width + x];
      target = std::max(target, letter.buffer[row * letter.pitch + column]);
    }
  }
}

}  // namespace

MarkMask mask_of(const MarkBox& box) {
  MarkMask mask{whole(box.x0), whole(box.y0), 0, 0, {}};
  mask.width = std::max(1, whole(box.x1) - mask.x);
  mask.height = std::max(1, whole(box.y1) - mask.y);
  mask.coverage.assign(std::size_t(mask.width) * mask.height, 255);
  return mask;
}

MarkMask rim_of(const MarkMask& mask, int reach) {
  MarkMask rim{mask.x - reach, mask.y - reach, mask.width + 2 * reach, mask.height + 2 * reach, {}};
  rim.coverage.resize(std::size_t(rim.width) * rim.height);
  std::vector<int> half_widths;  // of the disc, row by row
  for (int dy = -reach; dy <= reach; ++dy) {
    half_widths.push_back(static_cast<int>(std::sqrt(reach * (reach + 1) - dy * dy)));
  }
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const std::uint8_t value = mask.coverage[std::size_t(y) * mask.width + x];
      if (value == 0) continue;
      for (int row = 0; row <= 2 * reach; ++row) {
        std::uint8_t* const line = &rim.coverage[std::size_t(y + row) * rim.width + x + reach];
        const int half = half_widths[static_cast<std::size_t>(row)];
        for (int dx = -half; dx <= half; ++dx) line[dx] = std::max(line[dx], value);
      }
    }
  }
  return rim;
}

struct MarkLetters::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  // Calls `put` with each letter's position in pixels. Returns the position after the last letter.
  float along(const std::string& text, const std::function<void(float)>& put) const {
    float pen = 0;
    for (std::size_t at = 0; at < text.size();) {
      const FT_UInt glyph = FT_Get_Char_Index(face, character_at(text, at));
      if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) != 0) continue;
      if (put) put(pen);
      pen += static_cast<float>(face->glyph->linearHoriAdvance) / 65536.0f;
    }
    return pen;
  }
  float ascender() const { return static_cast<float>(face->size->metrics.ascender) / kSubpixels; }
  float descender() const { return static_cast<float>(face->size->metrics.descender) / kSubpixels; }
};

MarkLetters::MarkLetters(float pixels_of_an_em, std::span<const unsigned char> file)
    : face_(std::make_unique<Face>()) {
  const auto size = static_cast<FT_F26Dot6>(std::lround(pixels_of_an_em * kSubpixels));
  if (FT_Init_FreeType(&face_->library) != 0 ||
      FT_New_Memory_Face(face_->library, file.data(), static_cast<FT_Long>(file.size()), 0,
                         &face_->face) != 0 ||
      FT_Set_Char_Size(face_->face, 0, size, kDotsPerInch, kDotsPerInch) != 0) {
    throw std::runtime_error("FreeType cannot use the program's letters, so nothing is written");
  }
}

MarkLetters::~MarkLetters() = default;

MarkMask MarkLetters::mask(const MarkText& text) const {
  constexpr int kRoom = 2;  // pixels; letters may stick out of their widths
  const float baseline = std::round(text.y + face_->ascender());
  MarkMask mask{static_cast<int>(std::floor(text.x)) - kRoom, whole(text.y) - kRoom, 0, 0, {}};
  mask.width = static_cast<int>(std::ceil(width(text.text))) + 2 * kRoom + 1;
  mask.height = static_cast<int>(std::ceil(line_height())) + 2 * kRoom;
  mask.coverage.resize(std::size_t(mask.width) * mask.height);
  FT_GlyphSlot const slot = face_->face->glyph;
  face_->along(text.text, [&](float pen) {
    const float x = text.x + pen, left = std::floor(x);
    if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return;
    FT_Outline_Translate(&slot->outline, static_cast<FT_Pos>((x - left) * kSubpixels), 0);
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return;
    put_on(mask, slot->bitmap, static_cast<int>(left) + slot->bitmap_left - mask.x,
           static_cast<int>(baseline) - slot->bitmap_top - mask.y);
  });
  return mask;
}

float MarkLetters::width(const std::string& text) const {
  return face_->along(text, {});
}

float MarkLetters::line_height() const {
  return face_->ascender() - face_->descender();
}

}  // namespace alphascope
