// SPDX-License-Identifier: GPL-3.0-or-later
// Records the open lesson: brings the window to each step and each answer. Another thread gets
// their pictures and texts, draws and writes them. Each step and each answer is a picture file, or
// some seconds of a movie.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/viewer/lessons/lesson_player.hpp"
#include "app/viewer/saving/picture_saver.hpp"
#include "ui/scene/picture/lesson_page.hpp"

namespace alphascope {

class LessonRecorder {
 public:
  // Takes the view on screen as a picture of this size.
  using TakePicture = std::function<Picture(const ScreenshotRequest& request)>;

  // All arguments must outlive the recorder.
  LessonRecorder(LessonPlayer& player, LessonState& memory, PictureSaver& saver,
                 TakePicture take_picture);

  // Records from the first step on. Throws std::runtime_error (a sentence) if no lesson is open or
  // another job runs, and what make_frame_sink() throws.
  void start(const RecordRequest& request, Theme theme);
  // Call once a frame, after the player. `quiet`: no work but the recording is running. Returns
  // once, as a sentence, why the recording was given up; otherwise an empty text.
  std::string step(bool quiet);
  bool busy() const { return pages_ != nullptr; }

 private:
  struct Page;
  class Pages;  // between the window's thread and the drawing thread
  static SceneJob job(const RecordRequest& request, std::shared_ptr<Pages> pages);
  bool undisturbed() const;
  void hand_over();
  void go_on();

  LessonPlayer& player_;
  LessonState& memory_;
  PictureSaver& saver_;
  TakePicture take_picture_;

  std::shared_ptr<Pages> pages_;  // null: no recording
  RecordRequest request_;
  Theme theme_ = Theme::dark;
  std::shared_ptr<const Lesson> lesson_;
  std::size_t step_ = 0;  // the step that the window has to show, with its answer if answer_ is set
  bool answer_ = false;
  int quiet_frames_ = 0;
};

}  // namespace alphascope
