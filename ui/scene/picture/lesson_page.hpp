// A step of a lesson as a picture that is understood alone: the view, and beside it what the lesson
// says, in the window's letters.
#pragma once

#include <string>
#include <vector>

#include "core/document/lessons/lesson.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

struct LessonPage {
  std::string chapter, place;         // "Union of balls", "step 2 of 7"
  std::string title;                  // of the step
  std::vector<LessonParagraph> text;  // with its facts; words between ** are bold
  Theme theme = Theme::dark;
};

// How large the view is in a picture of this size: the text is at its right, or below where the
// picture is higher than wide.
struct PageView {
  int width = 0, height = 0;
};
PageView page_view(int width, int height);

// `view`: opaque, of that size. Long text has smaller letters. Appends to `left_out` a sentence
// when even the smallest do not fit. Throws std::runtime_error when FreeType does not work.
Image lesson_picture(const Image& view, const LessonPage& page, int width, int height,
                     std::string& left_out);

}  // namespace alphascope
