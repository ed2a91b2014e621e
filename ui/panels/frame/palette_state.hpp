// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the command palette between frames. Plain data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alphascope {

struct PaletteState {
  bool show = false;
  std::string asking = {};              // id of the command that lacks arguments; empty: none
  std::vector<std::string> words = {};  // arguments given so far
  std::string typed = {};
  std::size_t chosen = 0;  // row of the list
  std::string error = {};  // why the typed command did not run
};

}  // namespace alphascope
