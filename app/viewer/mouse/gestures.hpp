// SPDX-License-Identifier: GPL-3.0-or-later
// Groups changes into gestures: all changes between the press of a mouse button or key and its
// release.
#pragma once

#include "core/document/session/editor.hpp"

namespace alphascope {

struct ViewState;

// Whether the user holds a mouse button, or alpha or the models are playing.
bool interacting(const ViewState& state);

// Whether a mouse button or key goes down in this frame.
bool anything_pressed();

class Gestures {
 public:
  // Call once a frame, after ImGui has begun it. Returns the current gesture, or 0 soon after all
  // buttons and keys are released.
  Gesture in_this_frame();

 private:
  Gesture count_ = 0;
  int frames_left_ = 0;  // until the gesture ends; settings follow a release one frame later
};

}  // namespace alphascope
