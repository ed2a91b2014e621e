// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the memory of the program and of the machine, and gives freed memory back when nothing
// runs.
#pragma once

#include "app/viewer/frames/due_frames.hpp"
#include "ui/panels/view_state.hpp"

namespace alphascope {

class MemoryWatch {
 public:
  MemoryWatch(ViewState& state, DueFrames& due) : state_(state), due_(due) {}

  void read();                                                    // into the state
  void note_freed(bool freed = true) { to_give_back_ |= freed; }  // a large object was freed
  // Gives freed memory back, unless `busy`: running work would allocate it again at once.
  void give_back_when_due(bool busy);

 private:
  ViewState& state_;
  DueFrames& due_;
  bool to_give_back_ = false;
};

}  // namespace alphascope
