// SPDX-License-Identifier: GPL-3.0-or-later
// Plays the open lesson: brings a step's molecule into the window, and runs its commands, one a
// frame. At the end it restores the previous molecule. It sees the window only as a LessonStage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/document/commands/commands.hpp"
#include "ui/panels/lessons/lesson_state.hpp"

namespace alphascope {

// The window as the player needs it.
class LessonStage {
 public:
  virtual ~LessonStage() = default;
  // Identity of the open file. Opening the same file again gives another identity. Null: no file.
  virtual std::shared_ptr<const void> file() const = 0;
  virtual std::filesystem::path path() const = 0;  // path of the open file
  virtual bool opening() const = 0;                // true while any file is being opened
  // True when the picture is that of the present settings, or when no picture is possible.
  virtual bool at_rest() const = 0;

  virtual void keep() = 0;  // keeps the open molecule with all its settings
  virtual void open(const std::filesystem::path& molecule) = 0;  // with a lesson's settings
  virtual void reset() = 0;  // gives the open file a lesson's settings
  virtual Outcome run(const std::string& command) = 0;
  virtual void settle() = 0;        // from here on undo leads back to the settings of the step
  virtual void restore_kept() = 0;  // restores the kept molecule
  virtual void forget() = 0;  // as restore_kept(), but a file that the user has opened stays open
};

class LessonPlayer {
 public:
  // Both arguments must outlive the player.
  LessonPlayer(LessonStage& stage, LessonState& memory) : stage_(stage), memory_(memory) {}

  void begin(std::shared_ptr<const Lesson> lesson);
  void next();  // shows the answer of a question, otherwise the next step; no effect after the last
  void back();
  void restart_step();  // starts the step again
  void restart();       // goes to the first step
  void reveal();        // shows the answer
  void close();

  // Call once a frame.
  void step();
  // True while a molecule is being opened or commands are left to run.
  bool busy() const { return memory_.open && phase_ != Phase::shown; }

 private:
  // A step that was just chosen is `arriving`, and while its molecule is being opened it is
  // `opening`. The player does nothing while any file is being opened, since it may have to keep
  // that one.
  enum class Phase : std::uint8_t { arriving, opening, running, shown };

  const LessonStep& now() const { return memory_.open->steps[memory_.step]; }
  void go_to(std::size_t step);
  void arrive();
  void take_asked();
  void run_next();
  void refuse(std::size_t line, const std::string& why);
  void notice_other_file();
  void leave();

  LessonStage& stage_;
  LessonState& memory_;
  Phase phase_ = Phase::shown;
  std::vector<LessonCommand> commands_;  // the commands left to run, from next_command_
  std::size_t next_command_ = 0;
  bool kept_ = false;
  std::shared_ptr<const void> ours_;  // the open file if a step has opened it, else null
  std::filesystem::path asked_;       // the file that a step has requested and that is not open yet
  std::shared_ptr<const void> before_;  // the file that was open at that request
};

}  // namespace alphascope
