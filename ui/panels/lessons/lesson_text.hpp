// SPDX-License-Identifier: GPL-3.0-or-later
// Draws paragraphs with bold words and lists, with line breaks at blanks.
#pragma once

#include <vector>

namespace alphascope {

struct LessonParagraph;
struct PanelContext;

// Draws the text in the remaining width. `size` is a factor on the usual letters.
void draw_lesson_text(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size = 1);
// Returns the height of the text in `width` pixels.
float lesson_text_height(PanelContext& ctx, const std::vector<LessonParagraph>& text, float size,
                         float width);

}  // namespace alphascope
