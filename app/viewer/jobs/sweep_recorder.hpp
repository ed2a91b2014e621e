// Records a sweep of alpha with what pages draw into the picture: cavities, channels, labels are
// made by the window for the complex on screen, so the window itself goes through the sweep. The
// thread that draws and writes says which alpha comes next.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/jobs/picture_saver.hpp"

namespace alphascope {

class SweepRecorder {
 public:
  struct Window {
    std::function<Picture(const ScreenshotRequest& request)> take_picture;  // of what is on screen
    std::function<void(const Alpha&)> set_alpha;                            // Å², of the slider
    std::function<Alpha()> alpha;                                           // Å², of the slider
    std::function<std::optional<Alpha>()> drawn_alpha;                      // Å², on screen
    std::function<const void*()> molecule;                                  // which one is open
  };

  SweepRecorder(PictureSaver& saver, Window window);

  // `texts`: of a movie as a whole. Throws what PictureSaver::start() and recording_job() throw.
  void start(const RecordRequest& request, PictureTexts texts);
  // Once a frame. `quiet`: nothing but the recording is on its way. Returns why it was given up, a
  // sentence, once; else empty. At the end alpha is again what it was.
  std::string step(bool quiet);
  bool busy() const { return exchange_ != nullptr; }

 private:
  class Exchange;  // between the threads
  void ask(const Alpha& alpha);
  std::string hand_over();  // why not; empty: it was
  std::string give_up(const std::string& why);

  PictureSaver& saver_;
  Window window_;
  std::shared_ptr<Exchange> exchange_;  // null: nothing is recorded
  RecordRequest request_;
  const void* molecule_ = nullptr;
  Alpha alpha_before_;                  // Å²
  std::optional<Alpha> asked_;          // Å², of the window
  std::optional<Viewpoint> viewpoint_;  // of all frames
  int quiet_frames_ = 0;
};

}  // namespace alphascope
