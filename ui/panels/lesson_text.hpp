// Paragraphs with bold words and lists, broken at blanks.
#pragma once

#include <vector>

#include "core/document/lesson.hpp"
#include "ui/panels/widgets.hpp"

namespace alphascope {

// In the width that is left.
void draw_lesson_text(PanelContext& ctx, const std::vector<LessonParagraph>& text);

}  // namespace alphascope
