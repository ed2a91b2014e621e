// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out and draws the text, in smaller letters if it does not fit.
#include "ui/scene/picture/lesson_page.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/geometry/lattice_alpha.hpp"
#include "ui/inter_font.hpp"
#include "ui/scene/picture/draw_marks.hpp"
#include "ui/scene/picture/mark_mask.hpp"

namespace alphascope {
namespace {

// Shares of the picture for the text: of the width beside the view, or of the height below it.
constexpr double kBeside = 0.38, kBelow = 0.42;
// Pixels of an em at scale 1. In ems: margin around the text, space between paragraphs, indent of
// items.
constexpr float kFontSize = 15, kMargin = 1.4f, kParagraph = 0.6f, kIndent = 1.1f;
constexpr float kLineHeight = 1.12f;  // factor on the font's line height
constexpr float kTitle = 1.15f, kSmall = 0.85f;
// Factors on the usual size.
constexpr float kLeastSize = 0.55f, kSizeStep = 0.05f;

struct Word {
  MarkText text;
  bool bold = false;
};

// Fonts of one size, and the positions of all words.
class PageLayout {
 public:
  PageLayout(float em, float width) : em_(em), width_(width) {}

  void lay_out(const LessonPage& page) {
    y_ = kMargin * em_;
    place_muted(page.chapter, kMargin * em_, small_);
    const float right = width_ - kMargin * em_ - small_.width(page.place);
    muted_.push_back({right, y_, page.place});
    y_ += kLineHeight * small_.line_height() + kParagraph * em_;
    add(page.title, true, kMargin * em_, title_);
    for (const LessonParagraph& paragraph : page.text) add_paragraph(paragraph);
  }
  float height() const { return y_ + kMargin * em_; }

  void draw(Image& image, int x, int y, const Palette& palette) const {
    for (const MarkText& text : muted_) put(image, small_, text, x, y, palette.text_muted);
    for (const Word& word : titles_) put(image, title_, word.text, x, y, palette.text);
    for (const Word& word : words_) {
      put(image, word.bold ? bold_ : regular_, word.text, x, y, palette.text);
    }
  }

 private:
  static void put(Image& image, const MarkLetters& letters, MarkText text, int x, int y,
                  const Colour& colour) {
    text.x += static_cast<float>(x);
    text.y += static_cast<float>(y);
    blend(image, letters.mask(text), colour);
  }
  void place_muted(const std::string& text, float x, const MarkLetters& letters) {
    const float room = width_ - 2 * kMargin * em_ - letters.width("  step 00 of 00");
    const TextWidth width = [&letters](const std::string& t) { return letters.width(t); };
    muted_.push_back({x, y_, fitted_text(text, room, width)});
  }
  void add_paragraph(const LessonParagraph& paragraph) {
    y_ += kParagraph * em_;
    float left = kMargin * em_;
    if (paragraph.item) {
      words_.push_back({{left, y_, "•"}, false});
      left += kIndent * em_;
    }
    pen_ = left;
    for (const LessonSpan& span : lesson_spans(paragraph.text)) {
      add_words(span.text, span.bold, left, span.bold ? bold_ : regular_, words_);
    }
    end_line(left, regular_);
  }
  void add(const std::string& text, bool bold, float left, const MarkLetters& letters) {
    pen_ = left;
    add_words(text, bold, left, letters, titles_);
    end_line(left, letters);
  }
  // Lines break at blanks only: a full stop that follows a bold word belongs to the next span.
  void add_words(const std::string& text, bool bold, float left, const MarkLetters& letters,
                 std::vector<Word>& to) {
    const float blank = letters.width(" ");
    std::size_t at = 0;
    while (at < text.size()) {
      if (text[at] == ' ') {
        if (pen_ > left) pen_ += blank;
        after_blank_ = true;
        ++at;
        continue;
      }
      const std::size_t end = std::min(text.find(' ', at), text.size());
      const std::string word = text.substr(at, end - at);
      const float size = letters.width(word);
      if (after_blank_ && pen_ > left && pen_ + size > width_ - kMargin * em_) {
        end_line(left, letters);
      }
      after_blank_ = false;
      to.push_back({{pen_, y_, word}, bold});
      pen_ += size;
      at = end;
    }
  }
  void end_line(float left, const MarkLetters& letters) {
    y_ += kLineHeight * letters.line_height();
    pen_ = left;
  }

  float em_, width_;
  MarkLetters regular_{em_}, bold_{em_, inter_semibold()}, small_{kSmall * em_},
      title_{kTitle * em_, inter_semibold()};
  float pen_ = 0, y_ = 0;
  bool after_blank_ = false;
  std::vector<MarkText> muted_;
  std::vector<Word> titles_, words_;
};

void put_view(Image& image, const Image& view) {
  for (int y = 0; y < std::min(view.height, image.height); ++y) {
    const std::uint8_t* const from = &view.rgba[4 * std::size_t(y) * view.width];
    std::copy(from, from + 4 * std::min(view.width, image.width),
              &image.rgba[4 * std::size_t(y) * image.width]);
  }
}

Image empty_page(int width, int height, const Colour& colour) {
  Image image{width, height, std::vector<std::uint8_t>(4 * std::size_t(width) * height)};
  const auto byte = [](float part) { return static_cast<std::uint8_t>(part * 255 + 0.5f); };
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const std::uint8_t pixel[] = {byte(colour.r), byte(colour.g), byte(colour.b), 255};
    std::copy(pixel, pixel + 4, &image.rgba[i]);
  }
  return image;
}

}  // namespace

PageView page_view(int width, int height) {
  if (width >= height) return {width - static_cast<int>(kBeside * width), height};
  return {width, height - static_cast<int>(kBelow * height)};
}

Image lesson_picture(const Image& view, const LessonPage& page, int width, int height,
                     std::string& left_out) {
  const Palette& colours = palette(page.theme);
  Image image = empty_page(width, height, colours.panel);
  put_view(image, view);
  const bool beside = width >= height;
  const int x = beside ? view.width : 0, y = beside ? 0 : view.height;
  const auto room = static_cast<float>(height - y);
  for (float size = 1;; size -= kSizeStep) {
    PageLayout layout(size * kFontSize * mark_unit(width, height), static_cast<float>(width - x));
    layout.lay_out(page);
    const bool fits = layout.height() <= room;
    if (!fits && size > kLeastSize) continue;
    layout.draw(image, x, y, colours);
    if (!fits) {
      left_out += std::string(left_out.empty() ? "" : " ") + "The text of “" + page.title +
                  "” is cut off: the pictures are too small for it.";
    }
    return image;
  }
}

}  // namespace alphascope
