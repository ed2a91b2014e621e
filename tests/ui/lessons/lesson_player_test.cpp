// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the player of lessons on a stage that only records requests.
#include "app/viewer/lessons/lesson_player.hpp"
#include "core/document/store/answer.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/work_threads.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLesson = R"(# Title
Summary.
```
molecule a.xyzr
common
```
## One
Text.
## Two
Text.
```
first
second
```
## Three
Text?
```
molecule b.xyzr
```
### Answer
Text.
```
answered
```
)";

class FakeStage : public LessonStage {
 public:
  std::shared_ptr<const void> file() const override { return file_; }
  fs::path path() const override { return path_; }
  bool opening() const override { return !coming_.empty(); }
  bool at_rest() const override { return at_rest_; }
  void keep() override { said_ += "keep " + path_.filename().string() + "; "; }
  void open(const fs::path& molecule) override {
    said_ += "open " + molecule.filename().string() + "; ";
    coming_ = molecule;
  }
  void reset() override { said_ += "reset; "; }
  Outcome run(const std::string& command) override {
    said_ += command + "; ";
    return command == "second" ? Outcome::refused("No.") : Outcome();
  }
  void settle() override { said_ += "settle; "; }
  void restore_kept() override { said_ += "bring back; "; }
  void forget() override { said_ += "forget; "; }

  // Ends the last request to open a file, which the player or the user made: with the file, or in
  // failure.
  void arrives() {
    path_ = std::exchange(coming_, fs::path());
    file_ = std::make_shared<int>();
  }
  void fails() { coming_.clear(); }
  void user_opens(const fs::path& path) { coming_ = path; }
  std::string said() { return std::exchange(said_, ""); }

  bool at_rest_ = true;

 private:
  std::shared_ptr<const void> file_;
  fs::path path_, coming_;
  std::string said_;
};

class LessonPlayerTest : public ::testing::Test {
 protected:
  LessonPlayerTest() {
    stage_.user_opens("/mine/own.pdb");
    stage_.arrives();
  }
  void begin() {
    player_.begin(std::make_shared<const Lesson>(read_lesson(kLesson, "/l/lesson.md")));
  }
  void steps(int count = 8) {
    for (int k = 0; k < count; ++k) player_.step();
  }
  // Opens a lesson, and carries out everything that its first step asks for.
  void begin_and_arrive() {
    begin();
    steps();
    stage_.arrives();
    steps();
    stage_.said();
  }

  FakeStage stage_;
  LessonState memory_;
  LessonPlayer player_{stage_, memory_};
};

TEST_F(LessonPlayerTest, KeepsOpensAndRuns) {
  begin();
  steps();
  EXPECT_EQ(stage_.said(), "keep own.pdb; open a.xyzr; ");
  EXPECT_FALSE(memory_.ready);
  EXPECT_TRUE(player_.busy());
  stage_.arrives();
  stage_.at_rest_ = false;
  steps();
  EXPECT_EQ(stage_.said(), "") << "no command before the picture is there";
  stage_.at_rest_ = true;
  steps();
  EXPECT_EQ(stage_.said(), "common; settle; ");
  EXPECT_TRUE(memory_.ready);
  EXPECT_FALSE(player_.busy());
  EXPECT_TRUE(memory_.open) << "its own molecule does not end it";
  EXPECT_FALSE(memory_.left);
}

TEST_F(LessonPlayerTest, OneCommandAFrame) {
  begin_and_arrive();
  player_.next();
  steps(1);
  EXPECT_EQ(stage_.said(), "reset; common; ");
  steps(1);
  EXPECT_EQ(stage_.said(), "first; ");
}

TEST_F(LessonPlayerTest, TheSameMoleculeIsNotOpenedAgain) {
  begin_and_arrive();
  player_.next();
  steps();
  EXPECT_EQ(stage_.said(), "reset; common; first; second; settle; ");
  EXPECT_EQ(memory_.refused, "/l/lesson.md, line 13: No.");
  player_.back();
  steps();
  EXPECT_EQ(stage_.said(), "reset; common; settle; ");
  EXPECT_EQ(memory_.refused, "");
  EXPECT_EQ(memory_.first_refused, "/l/lesson.md, line 13: No.") << "a script ends with it";
  EXPECT_EQ(memory_.step, 0u);
  player_.back();
  EXPECT_EQ(memory_.step, 0u);
}

TEST_F(LessonPlayerTest, NextRevealsBeforeItGoesOn) {
  begin_and_arrive();
  player_.next();
  player_.next();
  steps();
  stage_.arrives();
  steps();
  EXPECT_EQ(stage_.said(), "open b.xyzr; common; settle; ");
  EXPECT_FALSE(memory_.revealed);
  player_.next();
  steps();
  EXPECT_TRUE(memory_.revealed);
  EXPECT_EQ(stage_.said(), "answered; settle; ");
  player_.next();
  player_.reveal();
  steps();
  EXPECT_EQ(memory_.step, 2u);
  EXPECT_EQ(stage_.said(), "");
  player_.restart_step();
  EXPECT_FALSE(memory_.revealed);
}

TEST_F(LessonPlayerTest, AFileThatIsStillBeingOpenedIsWhatIsKept) {
  stage_.user_opens("/mine/next.pdb");
  begin();
  steps();
  EXPECT_EQ(stage_.said(), "");
  stage_.arrives();
  steps();
  EXPECT_EQ(stage_.said(), "keep next.pdb; open a.xyzr; ");
}

TEST_F(LessonPlayerTest, GoingOnWhileTheMoleculeIsOnItsWay) {
  begin();
  steps();
  player_.next();
  steps();
  stage_.arrives();
  steps();
  EXPECT_EQ(stage_.said(), "keep own.pdb; open a.xyzr; reset; common; first; second; settle; ");
  EXPECT_FALSE(memory_.left);
}

TEST_F(LessonPlayerTest, CloseBringsBackWhatWasKept) {
  begin_and_arrive();
  player_.close();
  EXPECT_EQ(stage_.said(), "bring back; ");
  EXPECT_FALSE(memory_.open);
  EXPECT_FALSE(memory_.shown);
  player_.close();
  steps();
  EXPECT_EQ(stage_.said(), "");
}

TEST_F(LessonPlayerTest, AnotherFileIsTheUsers) {
  begin_and_arrive();
  stage_.user_opens("/mine/other.pdb");
  steps();
  EXPECT_FALSE(memory_.left) << "not before it is there";
  stage_.arrives();
  steps();
  EXPECT_EQ(stage_.said(), "forget; ");
  EXPECT_TRUE(memory_.left);
  EXPECT_FALSE(memory_.ready);
  EXPECT_TRUE(memory_.open);
  player_.restart_step();
  steps();
  EXPECT_EQ(stage_.said(), "keep other.pdb; open a.xyzr; ");
  EXPECT_FALSE(memory_.left);
}

TEST_F(LessonPlayerTest, AnotherFileInPlaceOfTheSteps) {
  begin();
  steps();
  stage_.user_opens("/mine/other.pdb");
  stage_.arrives();
  steps();
  EXPECT_TRUE(memory_.left);
  EXPECT_EQ(stage_.said(), "keep own.pdb; open a.xyzr; forget; ");
  player_.close();
  EXPECT_EQ(stage_.said(), "") << "what the user opened stays";
}

TEST_F(LessonPlayerTest, NoCommandRunsOnTheUsersFile) {
  begin_and_arrive();
  player_.next();
  steps(1);
  stage_.said();
  stage_.user_opens("/mine/other.pdb");
  steps();
  stage_.arrives();
  steps();
  EXPECT_EQ(stage_.said(), "forget; ");
}

TEST_F(LessonPlayerTest, AMoleculeThatCannotBeOpenedIsTold) {
  begin();
  steps();
  stage_.fails();
  steps();
  EXPECT_EQ(memory_.refused, "/l/lesson.md, line 7: The molecule a.xyzr was not opened.");
  EXPECT_FALSE(memory_.ready);
  EXPECT_FALSE(player_.busy());
  player_.close();
  EXPECT_EQ(stage_.said(), "keep own.pdb; open a.xyzr; bring back; ");
}

}  // namespace
}  // namespace alphascope
