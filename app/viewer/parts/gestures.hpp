// Which changes belong together: those between a press of a mouse button or key and its release.
#pragma once

#include "core/document/session/editor.hpp"

namespace alphascope {

class Gestures {
 public:
  // Once a frame, after ImGui has begun it: the gesture that goes on, or 0 when no hand is on
  // mouse or keyboard.
  Gesture in_this_frame();

 private:
  Gesture count_ = 0;
  int frames_left_ = 0;  // until the gesture is over: what a release does shows in the next frame
};

}  // namespace alphascope
