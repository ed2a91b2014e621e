// Frames that are still to be drawn before the window may rest.
#pragma once

namespace alphascope {

struct DueFrames {
  // ImGui needs a frame or two after the last input until everything has settled (hover, popups).
  static constexpr int kSettling = 3;
  int count = kSettling;
  bool any() const { return count > 0; }
  void ask() { count = kSettling; }  // something has changed that is to be seen
};

}  // namespace alphascope
