// SPDX-License-Identifier: GPL-3.0-or-later
// Places to which the window is to be scrolled. Plain data.
#pragma once

#include <string>

namespace alphascope {

struct ScrollState {
  std::string widget;   // to be scrolled into sight, for scripts; empty: none
  std::string section;  // id of a section at the left, to be opened and scrolled to the top
  bool sections_overflow = false;  // the sections at the left do not fit
  float pinned_height = 0;         // of the section that does not scroll, pixels; 0: unknown yet
};

}  // namespace alphascope
