// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the frames that are still to be drawn before the window may rest.
#pragma once

namespace alphascope {

struct DueFrames {
  // ImGui needs one or two frames after the last input until everything (hover, popups) has
  // settled.
  static constexpr int kSettling = 3;
  int count = kSettling;
  bool news = false;  // results have arrived that no frame shows yet
  bool any() const { return count > 0; }
  void count_down() { count = any() ? count - 1 : 0; }  // for a frame that is being drawn
  void ask() { count = kSettling; }                     // for a change that is to be seen
  void ask_for_news() {  // for a result, which the next frame shows at once
    ask();
    news = true;
  }
};

}  // namespace alphascope
