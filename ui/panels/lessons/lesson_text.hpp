// Paragraphs with bold words and lists, broken at blanks.
#pragma once

#include <vector>

#include "core/document/lessons/lesson.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// In the width that is left, in letters of `size` times the usual.
void draw_lesson_text(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size = 1);
// How high that would be in `width` pixels.
float lesson_text_height(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size,
                         float width);

}  // namespace alphascope
