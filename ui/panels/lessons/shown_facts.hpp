// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about the complex on screen, in the text of a lesson.
#pragma once

#include <vector>

namespace alphascope {

struct LessonFacts;
struct LessonParagraph;
struct LessonPart;
struct PanelContext;

// Returns facts of the picture, if it shows the step's molecule.
LessonFacts facts_on_screen(PanelContext& ctx);
// Returns the text with its facts. Adds it to LessonState::said and LessonState::paragraphs.
std::vector<LessonParagraph> with_facts_in(PanelContext& ctx, const LessonPart& part,
                                           const LessonFacts& facts);

}  // namespace alphascope
