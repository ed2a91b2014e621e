// SPDX-License-Identifier: GPL-3.0-or-later
// The phases of a lesson's step, from the request of its molecule to its last command.
#include "app/viewer/lessons/lesson_player.hpp"

#include <utility>

#include "core/text/printable.hpp"

namespace alphascope {

void LessonPlayer::begin(std::shared_ptr<const Lesson> lesson) {
  memory_.open = std::move(lesson);
  go_to(0);
}

void LessonPlayer::next() {
  if (!memory_.open) return;
  if (now().asks() && !memory_.revealed) return reveal();
  if (memory_.step + 1 < memory_.open->steps.size()) go_to(memory_.step + 1);
}

void LessonPlayer::back() {
  if (memory_.open && memory_.step > 0) go_to(memory_.step - 1);
}

void LessonPlayer::restart_step() {
  if (memory_.open) go_to(memory_.step);
}

void LessonPlayer::restart() {
  if (memory_.open) go_to(0);
}

// Shows the answer. Its commands follow those of the step, which may still be running.
void LessonPlayer::reveal() {
  if (!memory_.open || !now().asks() || memory_.revealed) return;
  memory_.revealed = true;
  memory_.whole = false;
  const auto& more = now().answer.commands;
  commands_.insert(commands_.end(), more.begin(), more.end());
  if (phase_ == Phase::shown && !memory_.left) phase_ = Phase::running;
}

void LessonPlayer::close() {
  if (!memory_.open) return;
  if (kept_) stage_.restore_kept();
  LessonState closed;
  closed.shelf = memory_.shelf;
  closed.first_refused = memory_.first_refused;
  memory_ = closed;
  kept_ = false;
  ours_ = before_ = nullptr;
  asked_.clear();
  phase_ = Phase::shown;
}

void LessonPlayer::go_to(std::size_t step) {
  memory_.shown = true;
  memory_.list = false;
  memory_.step = step;
  memory_.revealed = memory_.ready = memory_.whole = false;
  memory_.refused.clear();
  memory_.scroll_to_top = true;
  commands_ = memory_.open->commands;
  const auto& own = now().shown.commands;
  commands_.insert(commands_.end(), own.begin(), own.end());
  next_command_ = 0;
  phase_ = Phase::arriving;
}

void LessonPlayer::step() {
  if (!memory_.open || stage_.opening()) return;
  take_asked();
  notice_other_file();
  if (phase_ == Phase::arriving) arrive();
  if (phase_ == Phase::running && stage_.at_rest()) run_next();
}

// Checks whether the file that a step requested was opened.
void LessonPlayer::take_asked() {
  if (asked_.empty()) return;
  const std::filesystem::path asked = std::exchange(asked_, {});
  const bool came = stage_.file() != std::exchange(before_, nullptr);
  if (came) ours_ = stage_.file();
  const bool another = came && stage_.path() != asked;
  if (another) return leave();
  if (phase_ != Phase::opening) return;  // the user has chosen another step meanwhile
  phase_ = came ? Phase::running : Phase::shown;
  if (!came) refuse(now().line, "The molecule " + asked.filename().string() + " was not opened.");
}

// Requests the step's molecule. Before the first step, keeps the molecule that is open.
void LessonPlayer::arrive() {
  memory_.left = false;
  if (!std::exchange(kept_, true)) stage_.keep();
  const std::filesystem::path wanted = memory_.open->molecule_of(now());
  if (ours_ && stage_.path() == wanted) {
    stage_.reset();
    phase_ = Phase::running;
    return;
  }
  asked_ = wanted;
  before_ = stage_.file();
  stage_.open(wanted);
  phase_ = Phase::opening;
}

void LessonPlayer::run_next() {
  if (next_command_ < commands_.size()) {
    const LessonCommand& command = commands_[next_command_++];
    const Outcome outcome = stage_.run(command.text);
    if (!outcome.done()) refuse(command.line, outcome.why);
    return;
  }
  stage_.settle();
  memory_.ready = true;
  phase_ = Phase::shown;
}

void LessonPlayer::refuse(std::size_t line, const std::string& why) {
  const std::string text =
      printable(memory_.open->file.string()) + ", line " + std::to_string(line) + ": " + why;
  memory_.refused += (memory_.refused.empty() ? "" : "\n") + text;
  if (memory_.first_refused.empty()) memory_.first_refused = text;
}

void LessonPlayer::notice_other_file() {
  if (ours_ && stage_.file() != ours_) leave();
}

// Ends the lesson after the user has opened another file. Closing the lesson leaves that file open.
void LessonPlayer::leave() {
  ours_ = nullptr;
  memory_.ready = false;
  if (std::exchange(kept_, false)) stage_.forget();
  if (phase_ == Phase::arriving) return;
  memory_.left = true;
  phase_ = Phase::shown;
}

}  // namespace alphascope
