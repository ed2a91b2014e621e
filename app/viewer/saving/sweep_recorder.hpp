// SPDX-License-Identifier: GPL-3.0-or-later
// Records a sweep of alpha together with drawings of pages, such as cavities and channels. The
// window makes these drawings only for the complex on screen. So it goes through the sweep itself,
// and the thread that draws and writes requests each alpha.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/saving/picture_saver.hpp"
#include "core/geometry/alpha.hpp"

namespace alphascope {

class SweepRecorder {
 public:
  struct Window {
    std::function<Picture(const ScreenshotRequest& request)> take_picture;  // the picture on screen
    std::function<void(const Alpha&)> set_alpha;                            // sets the slider, Å²
    std::function<Alpha()> alpha;                       // value of the slider, Å²
    std::function<std::optional<Alpha>()> drawn_alpha;  // alpha of the complex on screen, Å²
    std::function<const void*()> molecule;              // identity of the open molecule
  };

  SweepRecorder(PictureSaver& saver, Window window);

  // `texts` describe the whole movie. Throws as PictureSaver::start() and recording_job() do.
  void start(const RecordRequest& request, PictureTexts texts);
  // Call once a frame. `quiet`: no work but the recording is running. Returns once, as a sentence,
  // why the recording was given up; otherwise an empty text. At its end alpha gets its former
  // value.
  std::string step(bool quiet);
  bool busy() const { return exchange_ != nullptr; }

 private:
  class Exchange;  // between the window's thread and the drawing thread
  void ask(const Alpha& alpha);
  std::string hand_over();  // returns why it failed; empty: success
  std::string give_up(const std::string& why);

  PictureSaver& saver_;
  Window window_;
  std::shared_ptr<Exchange> exchange_;  // null: no recording
  RecordRequest request_;
  const void* molecule_ = nullptr;
  Alpha alpha_before_;                  // Å², before the recording
  std::optional<Alpha> asked_;          // Å², last set in the window
  std::optional<Viewpoint> viewpoint_;  // the same for all frames
  int quiet_frames_ = 0;
};

}  // namespace alphascope
