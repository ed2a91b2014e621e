// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lessons line by line. The meaning of a line depends on the part that it belongs to.
#include "core/document/lessons/lesson.hpp"

#include <algorithm>

#include "core/document/lessons/lesson_facts.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/run/stage_timer.hpp"
#include "core/text_files/line_reader.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kFence = "```", kMolecule = "molecule", kBold = "**";
constexpr std::string_view kAnswer = "### Answer";

class LessonReader {
 public:
  explicit LessonReader(const std::filesystem::path& file) { lesson_.file = file; }

  Lesson read(std::string_view text) {
    if (text.size() > kLargestLesson) {
      fail("it is larger than a lesson can be (256 KiB)", "Divide it into two lessons");
    }
    LineReader lines(text);
    for (std::string_view line; lines.next(line);) {
      number_ = lines.number();
      take(trimmed(line));
    }
    finish();
    return std::move(lesson_);
  }

 private:
  [[noreturn]] void fail_at(std::size_t line, const std::string& reason,
                            const std::string& remedy) const {
    throw ReadError(lesson_.file, line, reason, remedy);
  }
  [[noreturn]] void fail(const std::string& reason, const std::string& remedy) const {
    fail_at(number_, reason, remedy);
  }

  void take(std::string_view line) {
    if (!is_printable(line)) {
      fail("it has characters that cannot be shown", "Write it as plain text in UTF-8");
    }
    if (fenced_) return take_command(line);
    if (line.starts_with(kFence)) return begin_fence();
    if (line.starts_with("#")) return take_heading(line);
    take_text(line);
  }

  // --- headings

  void take_heading(std::string_view line) {
    open_ = nullptr;
    if (line.starts_with("# ")) return take_title(trimmed(line.substr(2)));
    if (lesson_.title.empty())
      fail("the title is missing", "Begin with a line such as # My lesson");
    if (line == kAnswer) return begin_answer();
    if (!line.starts_with("## ")) {
      fail("\"" + std::string(line) + "\" is no heading of a lesson",
           "A lesson has # Title, ## Step and ### Answer");
    }
    begin_step(trimmed(line.substr(3)));
  }
  void take_title(std::string_view title) {
    if (!lesson_.title.empty()) fail("there is a second title", "Begin steps with ##");
    lesson_.title = title;
  }
  void begin_step(std::string_view title) {
    end_step();
    if (lesson_.summary.empty()) {
      fail("the summary is missing", "Say in a line below the title what the lesson is about");
    }
    if (lesson_.steps.size() == kMostLessonSteps) {
      fail("there are more than " + std::to_string(kMostLessonSteps) + " steps",
           "Divide it into two lessons");
    }
    lesson_.steps.push_back({.title = std::string(title), .line = number_, .molecule = molecule_});
    part_ = &lesson_.steps.back().shown;
  }
  void begin_answer() {
    if (lesson_.steps.empty()) fail("there is an answer before the first step", "Begin a step");
    LessonStep& step = lesson_.steps.back();
    if (answer_line_ != 0) fail("the step has a second answer", "Make two steps of it");
    if (step.shown.text.empty()) fail("there is an answer and no question", "Write the question");
    answer_line_ = number_;
    part_ = &step.answer;
  }
  void end_step() {
    if (lesson_.steps.empty()) return;
    const LessonStep& step = lesson_.steps.back();
    if (step.shown.text.empty()) {
      fail_at(step.line, "the step has no text", "Write below the heading what the step shows");
    }
    if (answer_line_ != 0 && !step.asks()) fail_at(answer_line_, "the answer is empty", "Write it");
    if (step.molecule.empty()) {
      fail_at(step.line, "the step has no molecule",
              "Name a file in its commands, such as molecule two_balls.xyzr");
    }
    answer_line_ = 0;
  }

  // --- commands

  void begin_fence() {
    open_ = nullptr;
    if (lesson_.title.empty())
      fail("the title is missing", "Begin with a line such as # My lesson");
    fenced_ = true;
    fence_line_ = number_;
  }
  void take_command(std::string_view line) {
    if (line.starts_with(kFence)) {
      fenced_ = false;
      return;
    }
    if (line.empty() || line.front() == '#') return;
    std::string_view rest = line;
    if (next_field(rest) == kMolecule) return take_molecule(trimmed(rest));
    auto& commands = part_ ? part_->commands : lesson_.commands;
    if (commands.size() == kMostLessonCommands) {
      fail("there are more than " + std::to_string(kMostLessonCommands) + " commands",
           "Make several steps of it");
    }
    commands.push_back({std::string(line), number_});
  }
  void take_molecule(std::string_view name) {
    if (name.empty()) fail("molecule names no file", "Write it as in molecule two_balls.xyzr");
    if (answer_line_ != 0) fail("an answer has another molecule", "Begin a step for it");
    (part_ ? lesson_.steps.back().molecule : molecule_) = name;
  }

  // --- text

  void take_text(std::string_view line) {
    if (line.empty()) {
      open_ = nullptr;
      return;
    }
    if (lesson_.title.empty())
      fail("the title is missing", "Begin with a line such as # My lesson");
    if (!part_) {
      lesson_.summary += (lesson_.summary.empty() ? "" : " ") + std::string(line);
      return;
    }
    const bool item = line.starts_with("- ");
    if (item || !open_) {
      part_->text.push_back({std::string(item ? trimmed(line.substr(2)) : line), item});
    } else {
      open_->text += " " + std::string(line);
    }
    open_ = &part_->text.back();
    check_facts(line);
  }
  void check_facts(std::string_view line) const {
    for (std::size_t at = line.find('{'); at != std::string_view::npos;
         at = line.find('{', at + 1)) {
      const std::size_t end = line.find('}', at);
      if (end == std::string_view::npos) fail("a { has no }", "Write facts as in {tetrahedra}");
      const std::string name(line.substr(at + 1, end - at - 1));
      if (!is_lesson_fact(name)) {
        fail("there is no fact \"" + name + "\"", "The facts are " + lesson_fact_names());
      }
    }
  }

  void finish() {
    if (fenced_) fail_at(fence_line_, "the commands do not end", "End them with a line of ```");
    if (lesson_.title.empty())
      fail_at(0, "the title is missing", "Begin with a line such as # My lesson");
    if (lesson_.steps.empty())
      fail_at(0, "there is no step", "Begin one with a line such as ## Two balls");
    end_step();
  }

  Lesson lesson_;
  std::filesystem::path molecule_;   // for steps that name none
  LessonPart* part_ = nullptr;       // to which lines belong; null before the first step
  LessonParagraph* open_ = nullptr;  // that the next line of text continues
  bool fenced_ = false;
  std::size_t number_ = 0, fence_line_ = 0, answer_line_ = 0;
};

}  // namespace

std::filesystem::path Lesson::molecule_of(const LessonStep& step) const {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::absolute(file, ignored).parent_path();
  return (folder / step.molecule).lexically_normal();
}

Lesson read_lesson(std::string_view text, const std::filesystem::path& file) {
  return LessonReader(file).read(text);
}

Lesson load_lesson(const std::filesystem::path& file) {
  const LoadedText loaded = load_text(file, kLargestLesson, {});
  return read_lesson(loaded.text, file);
}

std::size_t count_of_parts(const Lesson& lesson) {
  std::size_t parts = lesson.steps.size();
  for (const LessonStep& step : lesson.steps) parts += step.asks();
  return parts;
}

std::vector<LessonSpan> lesson_spans(std::string_view text) {
  std::vector<LessonSpan> spans;
  for (bool bold = false; !text.empty(); bold = !bold) {
    const std::size_t end = text.find(kBold);
    const std::string_view piece = text.substr(0, end);
    if (!piece.empty()) spans.push_back({std::string(piece), bold});
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + kBold.size());
  }
  return spans;
}

}  // namespace alphascope
