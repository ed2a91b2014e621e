// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: steps that the window plays, written as a text (docs/file-formats.md). This reads such
// texts; app/viewer/lessons plays them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// A command of the window, and its line in the text.
struct LessonCommand {
  std::string text;      // "alpha.set 1.4"
  std::size_t line = 0;  // from 1
};

// Words between ** are bold, names between { and } are facts (lesson_facts.hpp).
struct LessonParagraph {
  std::string text;
  bool item = false;  // of a list
};

// A text, and commands that make the window show its subject.
struct LessonPart {
  std::vector<LessonParagraph> text;
  std::vector<LessonCommand> commands;
};

struct LessonStep {
  std::string title;
  std::size_t line = 0;
  std::filesystem::path molecule;  // the file of the step, as written in the text
  LessonPart shown = {};
  LessonPart answer = {};  // empty text: the step has no question
  bool asks() const { return !answer.text.empty(); }
};

struct Lesson {
  std::filesystem::path file;
  std::string title, summary;
  std::vector<LessonCommand> commands;  // run at the start of each step
  std::vector<LessonStep> steps;        // at least one

  // Path of the step's file. A relative path counts from the lesson's folder.
  std::filesystem::path molecule_of(const LessonStep& step) const;
};

inline constexpr std::size_t kLargestLesson = 256 << 10;  // bytes
inline constexpr std::size_t kMostLessonSteps = 100;
inline constexpr std::size_t kMostLessonCommands = 50;  // of one part

// The number of parts that are read in turn: steps, and answers to their questions.
std::size_t count_of_parts(const Lesson& lesson);

// Throws ReadError with file, line, reason and remedy. It does not check whether the commands
// exist.
Lesson read_lesson(std::string_view text, const std::filesystem::path& file);
Lesson load_lesson(const std::filesystem::path& file);

// A piece of a paragraph; lesson_spans() returns all in order.
struct LessonSpan {
  std::string text;
  bool bold = false;
};
std::vector<LessonSpan> lesson_spans(std::string_view text);

}  // namespace alphascope
