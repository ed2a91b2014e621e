// What the window knows of lessons between frames: those that there are, and the one that is open.
// Plain data; the program fills it, the panel shows it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/document/lessons/lesson.hpp"

namespace alphascope {

// One file of lessons, in the order of their names.
struct ShelvedLesson {
  std::string name;                           // "union_of_balls": what lesson.open takes
  std::shared_ptr<const Lesson> lesson = {};  // null: it cannot be read
  std::string problem = {};                   // why not: file, line, reason, remedy
};

struct LessonMemory {
  bool shown = false;  // the column at the right
  bool list = false;   // it has the list, although a lesson is open
  std::shared_ptr<const std::vector<ShelvedLesson>> shelf;  // null: not read yet

  std::shared_ptr<const Lesson> open;  // null: none
  std::size_t step = 0;
  bool revealed = false;  // the answer to the step's question
  // The molecule of the step is on screen and its commands have run; facts are of this.
  bool ready = false;
  // Commands that the window refused: file, line and reason, a line each. Empty: none.
  std::string refused;
  bool left = false;  // another file was opened since: the step's molecule is not the open one
  std::string said;   // the text as it was shown last, with its facts
  std::vector<LessonParagraph> paragraphs;  // the same
  bool whole = false;  // that is of the step, with its answer if revealed, and no fact is missing
  bool scroll_to_top = false;  // the text is of another step than in the last frame
  float letters = 1;           // their size: long texts have smaller ones, within a step ever less
  bool overflows = false;      // the text does not even so find room, and scrolls
  bool more_below = false;     // it can be scrolled on
};

}  // namespace alphascope
