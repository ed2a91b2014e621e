// Plays the open lesson: brings a step's molecule into the window, runs its commands, one a frame,
// and puts back what was open before. Knows the window as a LessonStage only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/document/commands/commands.hpp"
#include "ui/panels/lessons/lesson_memory.hpp"

namespace alphascope {

// What the player needs of the window.
class LessonStage {
 public:
  virtual ~LessonStage() = default;
  // The file that is open, as an identity: opening it again gives another one. Null: none.
  virtual std::shared_ptr<const void> file() const = 0;
  virtual std::filesystem::path path() const = 0;  // its path
  virtual bool opening() const = 0;                // a file is on its way, whoever asked for it
  // The picture is that of the present settings, or there can be none.
  virtual bool at_rest() const = 0;

  virtual void keep() = 0;                                       // all of what is open now
  virtual void open(const std::filesystem::path& molecule) = 0;  // with a lesson's settings
  virtual void reset() = 0;                                      // to those, of the open file
  virtual Outcome run(const std::string& command) = 0;
  virtual void settle() = 0;      // what the step has set is what undo goes back to
  virtual void bring_back() = 0;  // what was kept
  virtual void forget() = 0;      // the same, but the file that the user has opened since stays
};

class LessonPlayer {
 public:
  // Both must live as long as this.
  LessonPlayer(LessonStage& stage, LessonMemory& memory) : stage_(stage), memory_(memory) {}

  void begin(std::shared_ptr<const Lesson> lesson);
  void next();  // the answer of a question, else the next step; nothing after the last
  void back();
  void again();    // the step as it begins
  void restart();  // the first step
  void reveal();   // the answer
  void close();

  // Once a frame.
  void step();
  // A molecule or commands are still to come.
  bool busy() const { return memory_.open && phase_ != Phase::shown; }

 private:
  // arriving: the step was gone to. opening: its molecule is on its way. In neither, nor while
  // commands run, anything is done before files that are being opened are there: one of them may
  // be what is to be kept.
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
  LessonMemory& memory_;
  Phase phase_ = Phase::shown;
  std::vector<LessonCommand> commands_;  // to be run
  std::size_t next_command_ = 0;
  bool kept_ = false;
  std::shared_ptr<const void> ours_;    // the open file, when a step has opened it; else null
  std::filesystem::path asked_;         // that a step has asked for and that has not come
  std::shared_ptr<const void> before_;  // that was open then
};

}  // namespace alphascope
