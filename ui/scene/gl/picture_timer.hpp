// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how long OpenGL takes to draw a picture, without waiting for it. No VTK.
#pragma once

#include <cstdint>
#include <optional>

namespace alphascope {

// A timer belongs to an OpenGL context, which must be current in each call.
class PictureTimer {
 public:
  PictureTimer() = default;
  PictureTimer(const PictureTimer&) = delete;
  PictureTimer& operator=(const PictureTimer&) = delete;

  // Starts the clock. Returns false if this OpenGL has no clock.
  bool start();
  // To be called when the whole picture has been handed over to OpenGL.
  void stop();
  // Milliseconds from start() until OpenGL has drawn everything handed over before stop(); each
  // time is returned once. Empty if no picture was timed, or if it is unfinished and `wait` is
  // false.
  std::optional<double> take_milliseconds(bool wait);

 private:
  unsigned query_ = 0;      // an OpenGL name
  std::int64_t begun_ = 0;  // ns on OpenGL's clock
  bool running_ = false;
};

}  // namespace alphascope
