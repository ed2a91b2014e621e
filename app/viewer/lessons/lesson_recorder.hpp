// Records the open lesson: brings the window to each step and to each answer, and hands its picture
// and text to the thread that draws and writes. Pictures are one a step; a movie shows each for a
// while.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/viewer/jobs/picture_saver.hpp"
#include "app/viewer/lessons/lesson_player.hpp"
#include "ui/scene/picture/lesson_page.hpp"

namespace alphascope {

class LessonRecorder {
 public:
  // What is on screen, as a picture of this size.
  using TakePicture = std::function<Picture(const ScreenshotRequest& request)>;

  // All of it must live as long as this.
  LessonRecorder(LessonPlayer& player, LessonMemory& memory, PictureSaver& saver,
                 TakePicture take_picture);

  // From the first step on. Throws std::runtime_error, a sentence, when no lesson is open or
  // something else is being saved; what make_frame_sink() throws.
  void start(const RecordRequest& request, Theme theme);
  // Once a frame, after the player. `quiet`: nothing but the recording is on its way. Returns why
  // it was given up, a sentence, once; else empty.
  std::string step(bool quiet);
  bool busy() const { return pages_ != nullptr; }

 private:
  struct Page;
  class Pages;  // between the threads
  static SceneJob job(const RecordRequest& request, std::shared_ptr<Pages> pages);
  bool undisturbed() const;
  void hand_over();
  void go_on();

  LessonPlayer& player_;
  LessonMemory& memory_;
  PictureSaver& saver_;
  TakePicture take_picture_;

  std::shared_ptr<Pages> pages_;  // null: nothing is recorded
  RecordRequest request_;
  Theme theme_ = Theme::dark;
  std::shared_ptr<const Lesson> lesson_;
  std::size_t step_ = 0;  // that the window is to show, with or without its answer
  bool answer_ = false;
  int quiet_frames_ = 0;
};

}  // namespace alphascope
