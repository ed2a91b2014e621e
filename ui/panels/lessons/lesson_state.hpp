// SPDX-License-Identifier: GPL-3.0-or-later
// The list of lessons, and the state of the open one. Plain data that the program fills and the
// panel shows.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/document/lessons/lesson.hpp"

namespace alphascope {

// One file of lessons. Files are listed by name.
struct ListedLesson {
  std::string name;                           // "union_of_balls": the argument of lesson.open
  std::shared_ptr<const Lesson> lesson = {};  // null: it cannot be read
  std::string problem = {};                   // why it cannot be read: file, line, reason, remedy
};

struct LessonState {
  bool shown = false;  // the column at the right is shown
  bool list = false;   // the column shows the list, although a lesson is open
  std::shared_ptr<const std::vector<ListedLesson>> shelf;  // null: not read yet

  std::shared_ptr<const Lesson> open;  // null: none
  std::size_t step = 0;
  bool revealed = false;  // the answer to the step's question is shown
  // The step's molecule is on screen and its commands have run. Facts in the text come from this.
  bool ready = false;
  // Commands that the window refused, one a line: file, line and reason. Empty: none.
  std::string refused;
  std::string first_refused;  // since the start, of any lesson; scripts end with it
  bool left = false;  // another file was opened since, so the step's molecule is not the open one
  std::string said;   // text shown last, with facts filled in
  std::vector<LessonParagraph> paragraphs;  // the same text as paragraphs
  // `said` is the step's whole text: the answer is revealed, and no fact is missing.
  bool whole = false;
  bool scroll_to_top = false;  // the step has changed since the last frame
  // Factor on the letters' size: longer texts get smaller ones; within a step it only falls.
  float letters = 1;
  bool overflows = false;   // the text does not fit even in the smallest letters, and scrolls
  bool more_below = false;  // the text goes on below
};

}  // namespace alphascope
