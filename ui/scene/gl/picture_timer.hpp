// How long OpenGL takes to draw a picture, without waiting for it. No VTK.
#pragma once

#include <cstdint>
#include <optional>

namespace alphascope {

// Belongs to an OpenGL context, which must be current whenever it is used.
class PictureTimer {
 public:
  PictureTimer() = default;
  PictureTimer(const PictureTimer&) = delete;
  PictureTimer& operator=(const PictureTimer&) = delete;

  // The picture begins now. False: this OpenGL has no clock.
  bool start();
  // All of the picture has been handed over.
  void stop();
  // From start() until OpenGL had drawn what was handed over until stop(), once. Nothing where no
  // picture was timed, and, unless told to wait for it, where it is not finished.
  std::optional<double> take_milliseconds(bool wait);

 private:
  unsigned query_ = 0;      // an OpenGL name
  std::int64_t begun_ = 0;  // ns on OpenGL's clock
  bool running_ = false;
};

}  // namespace alphascope
