// SPDX-License-Identifier: GPL-3.0-or-later
// The user guide in the window. Plain data that the program fills and the panel shows.
#pragma once

#include <memory>
#include <string>

namespace alphascope {

struct Guide;

struct GuideState {
  bool shown = false;
  bool to_front = false;  // the guide was asked for since the last frame
  // Null: not read yet, or `problem` tells why it cannot be read.
  std::shared_ptr<const Guide> guide;
  std::string problem;
  std::string asked_page;  // a page that a command asks for, by its name; empty: none
};

}  // namespace alphascope
