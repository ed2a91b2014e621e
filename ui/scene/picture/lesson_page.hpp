// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a lesson as a picture that can be understood alone. The lesson's text is beside the
// view, in the window's font.
#pragma once

#include <string>
#include <vector>

#include "core/document/lessons/lesson.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

struct LessonPage {
  std::string chapter, place;         // "Union of balls", "step 2 of 7"
  std::string title;                  // of the step
  std::vector<LessonParagraph> text;  // with its facts filled in; words between ** are bold
  Theme theme = Theme::dark;
};

// Size of the view (pixels) in a picture of this size. The text is to its right, or below it if the
// picture is higher than wide.
struct PageView {
  int width = 0, height = 0;
};
PageView page_view(int width, int height);

// `view` must be opaque and have the size of page_view(). Long text gets smaller letters. If even
// the smallest do not fit, a sentence is appended to `left_out`. Throws std::runtime_error if
// FreeType fails.
Image lesson_picture(const Image& view, const LessonPage& page, int width, int height,
                     std::string& left_out);

}  // namespace alphascope
