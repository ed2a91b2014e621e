// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that open a lesson and go through its steps.
#include "app/viewer/commands/command_parts.hpp"
#include "ui/panels/lessons/lesson_state.hpp"

namespace alphascope {
namespace {

struct Move {
  const char *id, *title, *help;
  void (LessonCalls::*call)();
  const char* key = nullptr;
};
constexpr Move kMoves[] = {
    {"lesson.next", "Next step of the lesson",
     "Shows the answer of a question, else goes to the next step", &LessonCalls::next, "PageDown"},
    {"lesson.back", "Step back in the lesson", "Goes to the step before", &LessonCalls::back,
     "PageUp"},
    {"lesson.reveal", "Reveal the answer", "Shows the answer to the question of this step",
     &LessonCalls::reveal},
    {"lesson.again", "Show the step again",
     "Restores the beginning of this step of the lesson, and opens its molecule again",
     &LessonCalls::restart_step},
    {"lesson.close", "Close the lesson", "Closes the lesson and restores the previous molecule",
     &LessonCalls::close}};

Outcome open_lesson(const Arguments& arguments, ViewState& s, const Calls& ask) {
  ask.lessons.open(arguments.text("lesson"));
  s.lessons.shown = s.lessons.list = true;
  return {};
}

}  // namespace

void add_lesson_commands(Commands& commands, ViewState& s, const Calls& ask) {
  commands.add(
      {.id = "lesson.open",
       .title = "Lessons…",
       .help = "Lists the lessons, or opens one by its name or file",
       .menu = "Help",
       .parameters = {{.name = "lesson",
                       .help = "Name of a lesson, or path of its file; if left out, all "
                               "are listed",
                       .example = "union_of_balls",
                       .optional = true}},
       .run = [&s, ask](const Arguments& arguments) { return open_lesson(arguments, s, ask); }});
  const auto without_lesson = [&s] { return s.lessons.open ? "" : "No lesson is open."; };
  for (const Move& move : kMoves) {
    CommandSpec spec{.id = move.id,
                     .title = move.title,
                     .help = move.help,
                     .why_not = without_lesson,
                     .run = [ask, call = move.call](const Arguments&) {
                       (ask.lessons.*call)();
                       return Outcome();
                     }};
    if (move.key) spec.keys_before_others = {{move.key}};
    commands.add(std::move(spec));
  }
}

}  // namespace alphascope
