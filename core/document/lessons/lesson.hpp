// A lesson: chapters that the window plays step by step, as a text that anybody can write
// (docs/file-formats.md). Reading such a text; playing it is the window's business.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alphascope {

// A command of the window, and where the text has it.
struct LessonCommand {
  std::string text;      // "alpha.set 1.4"
  std::size_t line = 0;  // from 1
};

// Words between ** are bold, names between { and } are facts (lesson_facts.hpp).
struct LessonParagraph {
  std::string text;
  bool item = false;  // of a list
};

// Something that is read while the window shows what the commands make of it.
struct LessonPart {
  std::vector<LessonParagraph> text;
  std::vector<LessonCommand> commands;
};

struct LessonStep {
  std::string title;
  std::size_t line = 0;
  std::filesystem::path molecule;  // the file that it is about, as the text has it
  LessonPart shown = {};
  LessonPart answer = {};  // without text: the step asks nothing
  bool asks() const { return !answer.text.empty(); }
};

struct Lesson {
  std::filesystem::path file;
  std::string title, summary;
  std::vector<LessonCommand> commands;  // that every step begins with
  std::vector<LessonStep> steps;        // at least one

  // Where the step's file is: beside the lesson, unless the text says otherwise.
  std::filesystem::path molecule_of(const LessonStep& step) const;
};

inline constexpr std::size_t kLargestLesson = 256 << 10;  // bytes
inline constexpr std::size_t kMostLessonSteps = 100;
inline constexpr std::size_t kMostLessonCommands = 50;  // of one part

// What is read one after the other: steps, and answers to their questions.
std::size_t count_of_parts(const Lesson& lesson);

// Throws ReadError with file, line, reason and remedy. Whether the window has the commands is not
// looked at here.
Lesson read_lesson(std::string_view text, const std::filesystem::path& file);
Lesson load_lesson(const std::filesystem::path& file);

// Pieces of a paragraph, in order.
struct LessonSpan {
  std::string text;
  bool bold = false;
};
std::vector<LessonSpan> lesson_spans(std::string_view text);

}  // namespace alphascope
