// What the command palette remembers between frames. Plain data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alphascope {

struct PaletteMemory {
  bool show = false;
  std::string asking = {};              // id of the command whose arguments are asked for, if any
  std::vector<std::string> words = {};  // those that were given already
  std::string typed = {};
  std::size_t chosen = 0;  // row of the list
  std::string error = {};  // why what was typed did not run
};

}  // namespace alphascope
